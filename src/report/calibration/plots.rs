use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Layer, Measure};
use crate::study::calibrate::Calibration;

/// What is left over against what was measured, a plot for each outcome.
pub(super) fn figures(found: &Calibration) -> Vec<Figure> {
    let mut outcomes: Vec<Outcome> = vec![];
    for remainder in found.remainders.iter().filter(|remainder| remainder.stationary.is_none()) {
        if !outcomes.contains(&remainder.outcome) {
            outcomes.push(remainder.outcome);
        }
    }
    let one = |outcome: &Outcome| {
        let of = found.remainders.iter().filter(|remainder| remainder.outcome == *outcome);
        let points: Vec<[f64; 2]> = of.filter_map(|r| Some([r.measured?, r.difference])).collect();
        let x = Measure::outcome(*outcome);
        let y = Measure { label: format!("computed − measured {}", x.label), ..x.clone() };
        let title = format!("Residuals of {}", x.label);
        let name = format!("residuals-{}", outcome.name().replace('_', "-"));
        (points.len() > 1).then(|| {
            Figure::new(name, title, Axis::linear(x), Axis::linear(y)).with(Layer::Dots {
                name: "shots".into(),
                hue: crate::report::plot::Hue::Series(0),
                points,
            })
        })
    };
    outcomes.iter().filter_map(one).collect()
}
