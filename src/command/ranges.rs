//! The ranges of a search: those of `--vary`, or the default ranges of a command.

use crate::command::request::Request;
use crate::parameters::Vary;
use crate::report::{SetupOrigin, setting_text};
use crate::study::Search;
use crate::{Error, Result, Setup};

/// The texts of ranges as arguments: `vary club.loft=4deg..20deg`.
fn as_arguments(ranges: impl IntoIterator<Item = String>) -> String {
    let each = ranges.into_iter().map(|range| format!("`vary {range}`"));
    each.collect::<Vec<_>>().join(" ")
}

/// A range as text: "club.loft=4deg..20deg". Without spaces, a shell needs no quotes.
fn range_text(range: &Vary) -> String {
    let [low, high] = [range.low, range.high].map(|end| setting_text(range.parameter, end));
    let high = high.split_once('=').map_or("", |(_, value)| value);
    format!("{low}..{high}").replace(' ', "")
}

/// Ranges of the launch, with the form of the spin that the setup has.
fn launch_ranges(setup: &Setup<f64>) -> [String; 2] {
    let spin = match setup.launch.spin {
        Some(_) => "spin",
        None => "backspin",
    };
    [
        "launch.launch_angle=5deg..20deg".into(),
        format!("launch.{spin}=1500rpm..4000rpm"),
    ]
}

/// The default ranges of a search over one drive: loft and attack angle; none if the setup gives
/// the launch of the ball.
///
/// # Errors
/// The errors of [`Search::longest_drive`].
pub fn loft_and_attack_angle(setup: &Setup<f64>) -> Result<Vec<Vary>> {
    if setup.launch.is_given() {
        return Ok(vec![]);
    }
    Ok(Search::longest_drive(setup)?.vary)
}

/// The default range of a search over swings: the loft alone, because the attack angle varies from
/// swing to swing.
///
/// # Errors
/// The errors of [`Search::longest_drive`].
pub fn loft(setup: &Setup<f64>) -> Result<Vec<Vary>> {
    Ok(vec![Search::longest_drive(setup)?.vary[0]])
}

/// The ranges of `--vary`, or the default ranges of a command without the parameters that the
/// request states.
pub struct SearchRanges {
    /// The setup at the start of the search, in which a varied parameter without a value has a
    /// start value. Ranges and options are read with it. The study receives the setup without these
    /// values, which is the drive as set up.
    pub initialized: Setup<f64>,
    vary: Vec<Vary>,
    /// The default ranges of parameters that the request states; these are not varied.
    held: Vec<Vary>,
}

impl SearchRanges {
    /// The ranges of `--vary` (`given`); without this option, the ranges that `defaults` returns,
    /// without the parameters that the request states, and without the parameter `along` of a
    /// chart. `setup` has the means of the swings, if there are swings.
    ///
    /// # Errors
    /// The errors of [`Request::with_starts`], [`Vary::read`] and `defaults`.
    pub fn new(
        given: &[String],
        request: &Request,
        setup: Setup<f64>,
        along: Option<Vary>,
        defaults: impl Fn(&Setup<f64>) -> Result<Vec<Vary>>,
    ) -> Result<Self> {
        let initialized = request.with_starts(setup, given, along)?;
        if !given.is_empty() {
            return Ok(Self {
                vary: Vary::read_all(&initialized, given)?,
                initialized,
                held: vec![],
            });
        }
        let mut ranges = Self::defaults(defaults(&initialized)?, request, initialized);
        let along = along.map(|along| along.parameter);
        ranges.vary.retain(|range| Some(range.parameter) != along);
        Ok(ranges)
    }

    /// Default ranges without the parameters that the request states.
    pub fn defaults(ranges: Vec<Vary>, request: &Request, initialized: Setup<f64>) -> Self {
        let (held, vary) = ranges
            .into_iter()
            .partition(|range| request.states(range.parameter.name));
        Self {
            initialized,
            vary,
            held,
        }
    }

    /// Two ranges of a map of this setup, as arguments.
    ///
    /// # Errors
    /// The errors of [`Search::longest_drive`].
    pub fn of_map(setup: &Setup<f64>) -> Result<String> {
        if setup.launch.is_given() {
            return Ok(as_arguments(launch_ranges(setup)));
        }
        let ranges = Search::longest_drive(setup)?.vary;
        Ok(as_arguments(ranges.iter().map(range_text)))
    }

    /// The description of the setup for the first lines of the answer of a search over these
    /// ranges. Its field `held` has the parameters of the default ranges that the search does not
    /// vary, because the request states them.
    pub fn origin(&self, request: &Request) -> SetupOrigin {
        let held: Vec<_> = self.held.iter().map(|range| range.parameter).collect();
        let origin = request.origin_of_search(&self.vary);
        origin.with_held(&held, &self.initialized)
    }

    /// The reason why there is no range to vary, with examples of ranges; `None` if there is a
    /// range.
    pub fn reason(&self) -> Option<String> {
        if !self.vary.is_empty() {
            return None;
        }
        let names: Vec<_> = self.held.iter().map(|range| range.parameter.name).collect();
        let examples = match self.held.as_slice() {
            [] => as_arguments(launch_ranges(&self.initialized)),
            held => as_arguments(held.iter().map(range_text)),
        };
        Some(match names.as_slice() {
            [] => format!(
                "the drive is given by its launch, so there is no loft and no attack angle to \
                 vary; give the parameters of the launch to vary, for example {examples}"
            ),
            [name] => format!(
                "nothing is left to vary: {name} is stated, and so not varied; to vary it, give a \
                 range, for example {examples}"
            ),
            _ => format!(
                "nothing is left to vary: {} are stated, and so not varied; to vary them, give \
                 ranges, for example {examples}",
                names.join(" and ")
            ),
        })
    }

    /// The ranges to vary.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if there are no ranges.
    pub fn vary(self) -> Result<Vec<Vary>> {
        match self.reason() {
            None => Ok(self.vary),
            Some(reason) => Err(Error::unreadable("the search", reason)),
        }
    }
}
