//! The deliveries that explain measured launches, as text, JSON and files.

mod recovered;
mod text;

pub use recovered::{population_warnings, recovered_csv, recovered_toml};

use super::document::Document;
use super::reply::{Ending, Report, share};
use super::setup_file::CommentedSetup;
use super::shown;
use crate::error::Result;
use crate::parameters::{Parameter, Setup, SetupFile};
use crate::study::delivery::{
    Explained, Population, Posterior, ShotDelivery, Spread, Unidentified, setup_of_shots,
};
use crate::units::{Message, System, counted, counted_of};
use serde::Serialize;
use text::{median_identified, of_one, of_table, verdict};

/// The deliveries that explain measured launches, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DeliveryReport<'a> {
    #[serde(skip)]
    deliveries: &'a [ShotDelivery],
    /// True for launches from a table, false for a single launch.
    #[serde(skip)]
    is_table: bool,
    /// Number of rows that were not computed because of an interruption.
    #[serde(skip)]
    left_out: usize,
    /// The delivery of each shot; one entry for a single shot.
    pub rows: Vec<DeliveryRow>,
    /// Mean and standard deviation of each parameter over the shots.
    pub spread: Vec<Spread>,
    /// The normal distribution of the swings behind the shots, without the measurement errors of
    /// the launch monitor; `null` for fewer than 10 shots with a delivery.
    pub population: Option<&'a Population>,
}

/// The delivery of a shot.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DeliveryRow {
    /// The row in the table, from 1.
    pub row: usize,
    /// The status of the fit: `converged`, `unexplained` (no delivery within the ranges agrees with
    /// the launch and the stated club values), `stalled`, `iteration-limit`, or the status of the
    /// error.
    pub status: &'static str,
    /// The status in a sentence.
    pub message: String,
    /// The parameters of the delivery.
    pub known: Vec<Posterior>,
    /// The launch, measured and computed.
    pub explained: Vec<Explained>,
    /// Changes of the delivery that the launch does not determine, the least determined first.
    #[serde(rename = "untold")]
    pub unidentified: Vec<Unidentified>,
}

impl<'a> DeliveryReport<'a> {
    /// The report of deliveries and of their population. `is_table` is true for launches from a
    /// table, false for a single launch. `left_out` is the number of rows that were not computed
    /// because of an interruption.
    pub fn new(
        deliveries: &'a [ShotDelivery],
        population: Option<&'a Population>,
        is_table: bool,
        left_out: usize,
    ) -> Self {
        Self {
            deliveries,
            is_table,
            left_out,
            rows: deliveries.iter().map(DeliveryRow::new).collect(),
            spread: Spread::of(deliveries),
            population,
        }
    }
}

impl Report for DeliveryReport<'_> {
    const COMMAND: &'static str = "delivery";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done", "partial", "no-answer", "interrupted"];

    fn ending(&self) -> Ending {
        let (all, left_out) = (self.deliveries, self.left_out);
        if left_out > 0 {
            let rows = counted(left_out as u64, "row");
            return Ending {
                status: "interrupted",
                message: Some(format!("interrupted before {rows} were computed")),
            };
        }
        let found = all.iter().filter_map(ShotDelivery::explained).count();
        Ending {
            status: share(found, all.len()),
            message: all.iter().find_map(|delivery| match &delivery.found {
                Ok(delivered) => verdict(delivered).1.map(|message| message.to_string()),
                Err(error) => Some(error.to_string()),
            }),
        }
    }

    /// The delivery of a single shot. For a table, the deliveries with their means and standard
    /// deviations.
    fn document(&self, system: System) -> Document {
        match self.deliveries {
            [ShotDelivery { found: Ok(one), .. }, ..] if !self.is_table => of_one(one, system),
            all => of_table(all, self.population, system),
        }
    }
}

impl DeliveryRow {
    fn new(delivery: &ShotDelivery) -> Self {
        let row = delivery.row;
        match &delivery.found {
            Ok(delivered) => {
                let (status, message) = verdict(delivered);
                Self {
                    row,
                    status,
                    message: message
                        .map_or_else(|| delivered.message.clone(), |message| message.to_string()),
                    known: delivered.posteriors.clone(),
                    explained: delivered.explained.clone(),
                    unidentified: delivered.unidentified.clone(),
                }
            }
            Err(error) => Self {
                row,
                status: error.status(),
                message: error.to_string(),
                known: vec![],
                explained: vec![],
                unidentified: vec![],
            },
        }
    }
}

/// Warnings about parameters at a bound of their search range: the bound, not the launch,
/// determines the values of these parameters.
pub fn bound_warnings(all: &[ShotDelivery], system: System) -> Vec<Message> {
    let found: Vec<_> = all
        .iter()
        .filter_map(|delivery| delivery.found.as_ref().ok())
        .collect();
    let unknowns = found
        .first()
        .map_or(&[][..], |delivered| &delivered.posteriors)
        .iter()
        .map(|known| known.unknown);
    let ends = unknowns.flat_map(|unknown| [(unknown, false), (unknown, true)]);
    ends.filter_map(|(unknown, is_upper)| {
        let parameter = unknown.parameter;
        let known = found.iter().flat_map(|delivered| &delivered.posteriors);
        let at_end = known.filter(|known| {
            let [low, high] = known.unknown.range;
            known.unknown.parameter == parameter
                && known.sigma.is_none()
                && (known.value - low > high - known.value) == is_upper
        });
        let mut values: Vec<f64> = at_end.map(|known| known.value).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (values.first()?, values.last()?);
        let ends = [*first, *last].map(|end| shown::parameter(parameter, end, system));
        let ends = if ends[0] == ends[1] {
            ends[0].clone()
        } else {
            ends.join(" to ")
        };
        Some(Message::from(format!(
            "{} of {} lies at the {} end of its search range, {ends}: the range, not \
             the launch, determines this value; `set` {} to a value nearer to the golfer's, or give \
             it a larger `sigma`",
            parameter.name,
            counted_of(
                values.len() as u64,
                found.len() as u64,
                ["launch", "launches"]
            ),
            if is_upper { "upper" } else { "lower" },
            parameter.name,
        )))
    })
    .collect()
}

/// A warning for each parameter for which the rows state different values and that is not an
/// unknown: the written setup and the written swings have the mean of these values.
pub fn difference_warnings(all: &[ShotDelivery], system: System) -> Vec<Message> {
    let given = Spread::of_given(all).into_iter().filter(Spread::differs);
    given
        .map(|given| {
            let parameter = given.parameter;
            Message::from(format!(
                "{} differs between the rows: the setup and the distribution of the swings have \
                 its mean, {}; `only COLUMN=VALUE` selects rows",
                parameter.name,
                shown::parameter(parameter, given.mean, system)
            ))
        })
        .collect()
}

/// Warnings about unstated parameters that lie far from their prior: few golfers have such values,
/// so the launch or its units may be wrong. Parameters at a bound have a warning of their own
/// ([`bound_warnings`]).
pub fn unusual_warnings(all: &[ShotDelivery], system: System) -> Vec<Message> {
    /// A value is unusual if it is more than this number of prior standard deviations from its
    /// prior.
    const FAR: f64 = 3.0;
    let found: Vec<_> = all
        .iter()
        .filter_map(|delivery| delivery.found.as_ref().ok())
        .collect();
    let first = found.first().map_or(&[][..], |first| &first.posteriors);
    let warning = |parameter: &'static Parameter| {
        let known = found.iter().flat_map(|delivered| &delivered.posteriors);
        let far: Vec<&Posterior> = known
            .filter(|known| known.unknown.parameter == parameter && known.sigma.is_some())
            // a row may state a value that other rows do not state
            .filter(|known| !known.unknown.is_stated() && known.residual().abs() > FAR)
            .collect();
        let first = far.first()?;
        let show = |value| shown::parameter(parameter, value, system);
        let launches = ["launch", "launches"];
        Some(Message::from(format!(
            "{} of {} is more than {FAR} prior standard deviations from {}, for example {}: check \
             the values and units of the launch, or `set` {} to a value nearer to the golfer's",
            parameter.name,
            counted_of(far.len() as u64, found.len() as u64, launches),
            show(first.unknown.prior),
            show(first.value),
            parameter.name,
        )))
    };
    first
        .iter()
        .filter_map(|known| warning(known.unknown.parameter))
        .collect()
}

/// If a launch removes less than this fraction of a parameter's prior variance, the prior alone
/// determines the value. Texts show such a fraction as 0 %.
const UNIDENTIFIED: f64 = 0.005;

/// The setup with the most probable delivery of a shot, or with the mean of several deliveries and
/// of the other values that the table gives, for a setup file. `file` is the setup file or preset
/// that the request names. Comments are in the units of `system`.
///
/// # Errors
/// The errors of [`Setup::set_value`].
pub fn delivery_setup(
    setup: &Setup<f64>,
    all: &[ShotDelivery],
    file: &SetupFile,
    from: &str,
    system: System,
) -> Result<CommentedSetup> {
    let spread = Spread::of(all);
    let mut golfer = setup_of_shots(setup, all)?;
    let shots = counted(
        all.iter().filter_map(ShotDelivery::explained).count() as u64,
        "shot",
    );
    let given = Spread::of_given(all).into_iter().map(|given| {
        let remark = match given.deviation.filter(|_| given.differs()) {
            Some(deviation) => format!(
                "mean of {shots} of {from}, whose rows differ by a standard deviation of {}",
                shown::difference(given.parameter, deviation, system)
            ),
            None => format!("as in each row of {from}"),
        };
        (given.parameter, remark)
    });
    let mut remarks: Vec<_> = given.collect();
    for Spread {
        parameter,
        mean,
        deviation,
    } in spread
    {
        golfer.set_value(parameter, Some(mean))?;
        let scatter = deviation.map_or(String::new(), |deviation| {
            format!(
                ", with a standard deviation of {}",
                shown::difference(parameter, deviation, system)
            )
        });
        let remark = match median_identified(all, parameter) {
            Some(identified) if identified < UNIDENTIFIED => {
                format!("assumed: {shots} of {from} cannot determine it{scatter}")
            }
            Some(identified) => {
                let percent = 100.0 * identified;
                format!("recovered from {shots} of {from}, {percent:.0} % determined{scatter}")
            }
            None => format!("recovered from {shots} of {from}{scatter}"),
        };
        remarks.push((parameter, remark));
    }
    Ok(CommentedSetup {
        setup: golfer,
        about: vec![format!("{}, with the delivery of {from}", file.name)],
        remarks,
    })
}
