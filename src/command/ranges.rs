//! The default ranges of a search: the parameters that a command varies without `--vary`.

use crate::command::args::SwingsArgs;
use crate::command::request::Request;
use crate::parameters::{Parameter, Vary};
use crate::report::SetupOrigin;
use crate::study::Search;
use crate::{Error, Result, Setup};

/// The ranges of `--vary`; without this option, the ranges that `usual` gives.
///
/// # Errors
/// The errors of [`Vary::read`] and of `usual`.
pub fn varied(
    given: &[String],
    setup: &Setup<f64>,
    usual: impl FnOnce() -> Result<Vec<Vary>>,
) -> Result<Vec<Vary>> {
    match given {
        [] => usual(),
        given => given.iter().map(|text| Vary::read(setup, text)).collect(),
    }
}

/// The parameters of the default ranges that a search does not vary, because the request states
/// them. Empty with `--vary`. `usual` gives the default ranges.
///
/// # Errors
/// The errors of `usual`.
pub fn kept(
    given: &[String],
    usual: impl FnOnce() -> Result<DefaultRanges>,
) -> Result<Vec<&'static Parameter>> {
    match given {
        [] => Ok(usual()?.kept),
        _ => Ok(vec![]),
    }
}

impl Request {
    /// The description of the setup for the first lines of a search's answer. Its field `held` has
    /// the parameters of the default ranges that the search does not vary, because the request
    /// states them. `vary` are the ranges of the search, `given` the texts of `--vary`; `usual`
    /// gives the default ranges.
    ///
    /// # Errors
    /// The errors of `usual`.
    pub fn origin_with_held(
        &self,
        given: &[String],
        vary: &[Vary],
        setup: &Setup<f64>,
        usual: impl FnOnce(&Self, &Setup<f64>) -> Result<DefaultRanges>,
    ) -> Result<SetupOrigin> {
        let kept = kept(given, || usual(self, setup))?;
        Ok(self.origin_of_search(vary).with_held(&kept, setup))
    }
}

impl SwingsArgs {
    /// The default ranges of a search: the loft for a search over swings, and loft and attack angle
    /// for one drive.
    ///
    /// # Errors
    /// The errors of [`Search::longest_drive`].
    pub fn default_ranges(&self, request: &Request, setup: &Setup<f64>) -> Result<DefaultRanges> {
        match self.is_given() {
            true => DefaultRanges::loft(request, setup),
            false => DefaultRanges::longest_drive(request, setup),
        }
    }
}

/// The default ranges of a command. A parameter that the request states is not varied.
pub struct DefaultRanges {
    vary: Vec<Vary>,
    /// The parameters of the ranges that the request states; they are not varied.
    kept: Vec<&'static Parameter>,
}

impl DefaultRanges {
    /// Separates the parameters to vary from the parameters that the request states.
    pub fn new(ranges: Vec<Vary>, request: &Request) -> Self {
        let (kept, vary): (Vec<_>, Vec<_>) = ranges
            .into_iter()
            .partition(|range| request.states(range.parameter.name));
        Self {
            vary,
            kept: kept.into_iter().map(|range| range.parameter).collect(),
        }
    }

    /// Loft and attack angle; no range if the setup gives the launch of the ball.
    ///
    /// # Errors
    /// The errors of [`Search::longest_drive`].
    pub fn longest_drive(request: &Request, setup: &Setup<f64>) -> Result<Self> {
        let ranges = if setup.launch.is_given() {
            vec![]
        } else {
            Search::longest_drive(setup)?.vary
        };
        Ok(Self::new(ranges, request))
    }

    /// The loft alone, for a search over swings: there the attack angle varies from swing to swing.
    ///
    /// # Errors
    /// The errors of [`Search::longest_drive`].
    pub fn loft(request: &Request, setup: &Setup<f64>) -> Result<Self> {
        let loft = Search::longest_drive(setup)?.vary[0];
        Ok(Self::new(vec![loft], request))
    }

    /// Removes the parameter along which a chart runs.
    pub fn without(mut self, along: &Parameter) -> Self {
        self.vary.retain(|range| range.parameter.name != along.name);
        self
    }

    /// The reason why there is no range to vary; `None` if there is a range.
    pub fn reason(&self) -> Option<String> {
        if !self.vary.is_empty() {
            return None;
        }
        let names: Vec<_> = self.kept.iter().map(|parameter| parameter.name).collect();
        Some(match names.as_slice() {
            [] => "the drive is given by its launch, so there is no loft and no attack angle to \
                   vary; give the parameters of the launch to vary, for example `vary \
                   launch.launch_angle=5deg..20deg`"
                .into(),
            [name] => format!(
                "nothing is left to vary: {name} is stated, and so not varied; to vary it, give a \
                 range, for example `vary club.loft=4deg..20deg`; `simulate()` flies the drive as \
                 stated"
            ),
            _ => format!(
                "nothing is left to vary: {} are stated, and so not varied; to vary them, give a \
                 range, for example `vary club.loft=4deg..20deg`; `simulate()` flies the drive as \
                 stated",
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
