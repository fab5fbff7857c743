use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown::capital;
use crate::statistics::extent;
use crate::study::calibrate::{Calibration, FitResidual, ShotTable};
use crate::units::System;

struct MeasuredPoint {
    computed: f64,
    measured: f64,
    /// The standard uncertainty of the measured value.
    sigma: f64,
}

/// Two plots for each outcome with more than one measurement: the measured against the computed
/// values, and the residuals.
pub(super) fn figures(table: &ShotTable, found: &Calibration, system: System) -> Vec<Figure> {
    let mut outcomes: Vec<Outcome> = vec![];
    for residual in found
        .residuals
        .iter()
        .filter(|residual| residual.stationary.is_none())
    {
        if !outcomes.contains(&residual.outcome) {
            outcomes.push(residual.outcome);
        }
    }
    let two = |of: Outcome| {
        let points = points(table, found, of);
        (points.len() > 1).then(|| {
            [
                agreement(of, &points, system),
                residuals(of, &points, system),
            ]
        })
    };
    outcomes.into_iter().filter_map(two).flatten().collect()
}

fn points(table: &ShotTable, found: &Calibration, of: Outcome) -> Vec<MeasuredPoint> {
    let residuals = found
        .residuals
        .iter()
        .filter(|residual| residual.outcome == of);
    let point = |residual: &FitResidual| {
        let measured = residual.measured?;
        let shot = table.shots.iter().find(|shot| shot.row == residual.row)?;
        let sigma = shot
            .measured
            .iter()
            .find(|measurement| measurement.outcome == of)?
            .sigma;
        Some(MeasuredPoint {
            computed: measured + residual.difference,
            measured,
            sigma,
        })
    };
    residuals.filter_map(point).collect()
}

/// Plot of the measured against the computed values, with the line where both are equal.
fn agreement(of: Outcome, points: &[MeasuredPoint], system: System) -> Figure {
    let quantity = NamedQuantity::outcome(of);
    let labelled = |which: &str| {
        Axis::linear(NamedQuantity {
            label: format!("{which} {}", quantity.label),
            ..quantity.clone()
        })
    };
    let ends = |point: &MeasuredPoint| {
        let (low, high) = (point.measured - point.sigma, point.measured + point.sigma);
        [point.computed, low, high]
    };
    let [low, high] = extent(points.iter().flat_map(ends));
    let bar = |point: &MeasuredPoint| {
        let end = |sign: f64| [point.computed, point.measured + sign * point.sigma];
        [end(-1.0), end(1.0), [f64::NAN; 2]]
    };
    let equal = vec![[low, low], [high, high]];
    let mut figure = Figure::new(
        system,
        format!("measured-{}", of.name().replace('_', "-")),
        format!("{}: measured over computed", capital(&quantity.label)),
        labelled("computed"),
        labelled("measured"),
    )
    .with(Layer::new("equal", Hue::Faint, Shape::dashed(equal)))
    .with(Layer::line(
        "± one standard uncertainty",
        0,
        points.iter().flat_map(bar).collect(),
    ))
    .with(Layer::dots(
        "shots",
        0,
        points
            .iter()
            .map(|point| [point.computed, point.measured])
            .collect(),
    ))
    .noted(
        "The bars are the standard uncertainties of the measured values: from the table, or from \
         the instrument if the table states none.",
    );
    figure.aspect = 0.85;
    figure
}

/// Plot of the residuals of an outcome against its measured values.
fn residuals(of: Outcome, points: &[MeasuredPoint], system: System) -> Figure {
    let x = NamedQuantity::outcome(of);
    let y = NamedQuantity {
        label: format!("computed − measured {}", x.label),
        ..x.clone()
    };
    let title = format!("Residuals of {}", x.label);
    let name = format!("residuals-{}", of.name().replace('_', "-"));
    Figure::new(system, name, title, Axis::linear(x), Axis::linear(y)).with(Layer::dots(
        "shots",
        0,
        points
            .iter()
            .map(|point| [point.measured, point.computed - point.measured])
            .collect(),
    ))
}
