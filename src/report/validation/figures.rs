//! Plots of the laws, compared with published drives.

use crate::drive::Outcome;
use crate::parameters::Law;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::shots::instrument_deviation;
use crate::statistics::extent;
use crate::study::validation::{Case, Compared, LawScores, SetScores};
use crate::units::{Quantity, System};

/// An independent law. The report compares the default law with it.
pub(super) const ALTERNATIVE: &str = "ferguson";

/// The set of optima to plot. In this set the club is chosen so that its impact gives the ratio of
/// launch angle to spin on TrackMan's chart.
const OPTIMA: &str = "chart-optima-impact";

/// Name of the band that shows the difference between two launch monitors.
const INSTRUMENTS: &str = "two launch monitors";
/// The note on the band. It holds for all figures, and stands below the first one only.
const BAND: &str = "The band is one standard deviation of the difference between two launch \
                    monitors on the same drive (Bliss & Langdown 2026): 6.7 yd of carry, 12.3 ft \
                    of apex, 3.9° of descent, 513 rpm.";
const OPTIMUM: &str =
    "Computed spin at the loft of the longest carry, minus the spin on TrackMan's chart.";

/// The figures: the predicted against the measured carry, and the residuals of carry, apex, descent
/// and spin.
pub(super) fn figures(found: &[SetScores], system: System) -> Vec<Figure> {
    let measured: Vec<&SetScores> = found.iter().filter(|set| set.set.is_measured).collect();
    let optima: Vec<&SetScores> = found.iter().filter(|set| set.set.name == OPTIMA).collect();
    let mut laws = vec![Law::default().name(), ALTERNATIVE];
    for set in &measured {
        let best = best(set).map(|(_, law)| law);
        laws.extend(best.filter(|law| !laws.contains(law)));
    }
    let mut figures = vec![carry(&measured, system)];
    for of in [Compared::Carry, Compared::Apex, Compared::Descent] {
        figures.push(residuals(&measured, &laws, of, system));
    }
    figures.push(residuals(&optima, &laws, Compared::Spin, system));
    figures
}

/// Figure of the predicted against the measured carry. Each set is a series, computed with the
/// default law.
fn carry(sets: &[&SetScores], system: System) -> Figure {
    let default = Law::default().name();
    let carry = |words: &str| NamedQuantity::new(format!("{words} carry"), Quantity::LENGTH, "yd");
    let points = |set: &&SetScores| -> Vec<[f64; 2]> {
        let law = set.laws.iter().find(|law| law.law == default);
        of_law(law, Compared::Carry)
            .iter()
            .map(|one| [one.published, one.predicted])
            .collect()
    };
    let all: Vec<(&str, Vec<[f64; 2]>)> =
        sets.iter().map(|set| (set.set.name, points(set))).collect();
    let ends = ends(all.iter().flat_map(|(_, points)| points).map(|at| at[0]));
    let mut figure = Figure::new(
        system,
        "validation-carry",
        format!("Carry as {default} predicts it"),
        Axis::linear(carry("measured")),
        Axis::linear(carry("predicted")),
    );
    let exact = ends.map(|at| [at, at]);
    figure
        .layers
        .extend(without_error(Compared::Carry, "as measured", exact));
    for (i, (name, points)) in all.into_iter().enumerate() {
        figure = figure.with(Layer::dots(name, i, points));
    }
    figure.noted(BAND)
}

/// Figure of the residuals of a quantity. Each law is a series. The horizontal axis is the club
/// speed if the quantity is the spin, otherwise the ball speed.
fn residuals(sets: &[&SetScores], laws: &[&'static str], of: Compared, system: System) -> Figure {
    let is_spin = of == Compared::Spin;
    let (speed, drives) = match is_spin {
        true => ("club speed", "best loft"),
        false => ("ball speed", "all clubs"),
    };
    let speed_of = |case: &Case| match is_spin {
        true => case.club_speed,
        false => case.ball_speed,
    };
    let words = of.words();
    let series = |law: &&'static str| -> Vec<[f64; 2]> {
        let points = sets.iter().flat_map(|set| {
            let scores = set.laws.iter().find(|one| one.law == *law);
            let left = of_law(scores, of).iter();
            left.filter_map(|one| Some([speed_of(set.cases.get(one.case)?)?, one.difference]))
        });
        points.collect()
    };
    let all: Vec<Vec<[f64; 2]>> = laws.iter().map(series).collect();
    let ends = ends(all.iter().flatten().map(|at| at[0]));
    let x = NamedQuantity::new(speed, Quantity::SPEED, "mph");
    let y = NamedQuantity {
        label: format!("computed − published {words}"),
        of: of.unit(),
    };
    let name = match of {
        Compared::Carry => "validation-carry-residuals".into(),
        of => format!("validation-{}", of.name()),
    };
    let title = format!("Error of {words} by {speed}, {drives}");
    let mut figure = Figure::new(system, name, title, Axis::linear(x), Axis::linear(y));
    let exact = ends.map(|at| [at, 0.0]);
    figure.layers.extend(without_error(of, "", exact));
    for (i, (law, points)) in laws.iter().zip(all).enumerate() {
        figure = figure.with(Layer::dots(*law, i, points));
    }
    match is_spin {
        true => figure.noted(OPTIMUM),
        false => figure,
    }
}

/// The line of predictions without error through the points `ends`, with `name` in the legend. The
/// band around the line is ± one standard deviation of the difference between two launch monitors.
fn without_error(of: Compared, name: &str, ends: [[f64; 2]; 2]) -> Vec<Layer> {
    let outcome = match of {
        Compared::Carry => Some(Outcome::CarryDistance),
        Compared::Apex => Some(Outcome::ApexHeight),
        Compared::Descent => Some(Outcome::DescentAngle),
        Compared::Spin => Some(Outcome::Spin),
        Compared::Curve | Compared::Gain | Compared::LaunchAngle => None,
    };
    let band = outcome.and_then(instrument_deviation).map(|by| {
        Layer::new(
            INSTRUMENTS,
            Hue::Faint,
            Shape::Band(ends.map(|[x, y]| [x, y - by, y + by]).to_vec()),
        )
    });
    let line = Layer::new(name, Hue::Ink, Shape::dashed(ends.to_vec()));
    band.into_iter().chain([line]).collect()
}

fn of_law(law: Option<&LawScores>, of: Compared) -> &[crate::study::validation::Residual] {
    let score = law.and_then(|law| law.scores.iter().find(|score| score.of == of));
    score.map_or(&[], |score| &score.residuals)
}

/// The smallest and the largest value; both are 0 without data.
fn ends(of: impl Iterator<Item = f64>) -> [f64; 2] {
    Some(extent(of))
        .filter(|[low, high]| low <= high)
        .unwrap_or_default()
}

/// The smallest mean absolute error of the first quantity of a set, SI, and the law with this
/// error.
pub(super) fn best(set: &SetScores) -> Option<(f64, &'static str)> {
    let of = |law: &LawScores| law.scores.first()?.mean_absolute_error;
    set.laws
        .iter()
        .filter_map(|law| Some((of(law)?, law.law)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}
