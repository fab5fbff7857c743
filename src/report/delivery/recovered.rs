//! The swings behind measured shots, as a table (CSV) or as a distribution (TOML).

use crate::error::Result;
use crate::parameters::Parameter;
use crate::report::csv_text::{csv_text, number};
use crate::report::shown;
use crate::study::delivery::{
    MeanAndDeviation, Population, Posterior, PredictedOutcome, Recovered, ShotDelivery,
};
use crate::units::{DisplayUnit, Message, System, TableUnits, counted, significant, typed};

/// If a shot removes less than this fraction of a parameter's prior variance, the comment on the
/// parameter says that the rest is assumed.
const MOSTLY_PRIOR: f64 = 0.5;

/// The most probable swing behind each shot with a delivery, as CSV: a column for each
/// parameter, a row for each shot.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output).
pub fn recovered_csv(all: &[ShotDelivery], units: TableUnits) -> Result<String> {
    let mut found = all.iter().filter_map(ShotDelivery::explained).peekable();
    let Some(first) = found.peek() else {
        return Ok(String::new());
    };
    let parameters = first.posteriors.iter().map(|known| known.unknown.parameter);
    let head = parameters.map(|row| units.head(row.name, row));
    let value = |known: &Posterior| {
        let row = known.unknown.parameter;
        number(units.number(known.value, row))
    };
    csv_text(
        head.collect(),
        found.map(|delivered| delivered.posteriors.iter().map(value).collect()),
    )
}

/// A TOML file with the distribution of the swings behind shots. The comment on each parameter
/// states the fraction of its prior variance that a shot removes.
pub fn recovered_toml(population: &Population, from: &str, system: System) -> String {
    let shots = population.shots;
    let mut text = format!(
        "# the swings behind {} of {}: a joint normal distribution, without the errors of the \
         launch monitor\n",
        counted(shots as u64, "shot"),
        from.replace(char::is_control, " ")
    );
    for remark in population_warnings(population, system) {
        text += &format!("# {}\n", remark.in_units(system));
    }
    text += "\n[distributions]\n";
    for spread in &population.spreads {
        let Recovered {
            parameter,
            mean,
            deviation,
            variance_removed,
            mean_error,
            deviation_error,
        } = *spread;
        let [mean, deviation] = [mean, deviation].map(|value| amount(parameter, value, 9));
        let errors = [mean_error, deviation_error].map(|value| amount(parameter, value, 2));
        let rest = if variance_removed < MOSTLY_PRIOR {
            ", and the rest is assumed"
        } else {
            ""
        };
        let comment = format!(
            "mean ± {}, deviation ± {}; one shot reduces the assumed variance by {:.0} %{rest}",
            errors[0],
            errors[1],
            100.0 * variance_removed
        );
        text += &format!(
            "{} = \"normal({mean}, {deviation})\" # {comment}\n",
            parameter.name
        );
    }
    for (i, one) in population.spreads.iter().enumerate() {
        for (j, other) in population.spreads.iter().enumerate().take(i) {
            text += &format!(
                "\n[[correlations]]\nbetween = [\"{}\", \"{}\"]\ncoefficient = {:?}\n",
                other.parameter.name, one.parameter.name, population.correlations[i][j]
            );
        }
    }
    text
}

/// Warnings about a distribution of swings:
///
/// - The iterations did not converge.
/// - The deviation is below the prior deviation in directions that the shots do not identify.
/// - The distribution does not reproduce the measured launches.
pub fn population_warnings(population: &Population, system: System) -> Vec<Message> {
    let mut all = vec![];
    if !population.is_converged {
        let not_converged = "mean and deviation of the swings still changed when the iterations \
                             ended; give fewer parameters (`vary`)";
        all.push(not_converged.into());
    }
    if population.prior_factor < 1.0 {
        let part = significant(population.prior_factor, 3);
        all.push(format!(
            "in the directions that the shots do not identify, the deviation of the swings is \
             {part} of the assumed deviation: with the full deviation, their launches would scatter \
             differently from the shots"
        ));
    }
    let off: Vec<String> = population
        .mispredicted()
        .map(
            |PredictedOutcome {
                 of,
                 measured,
                 recovered,
             }| {
                let both = |MeanAndDeviation { mean, deviation }: MeanAndDeviation| {
                    format!(
                        "{} ± {}",
                        shown::outcome(*of, mean, system),
                        shown::difference(*of, deviation, system)
                    )
                };
                format!(
                    "{} {} in place of {}",
                    of.name(),
                    both(*recovered),
                    both(*measured)
                )
            },
        )
        .collect();
    if !off.is_empty() {
        all.push(format!(
            "the distribution of the swings does not reproduce the shots: a difference exceeds a \
             quarter of their scatter: {}; the table of swings (.csv) does not have this error",
            off.join(", ")
        ));
    }
    all.into_iter().map(Message::from).collect()
}

/// A value in the unit of its parameter.
fn amount(parameter: &Parameter, value: f64, digits: usize) -> String {
    let size = DisplayUnit::from(parameter).size();
    typed(&significant(value / size, digits), parameter.unit)
}
