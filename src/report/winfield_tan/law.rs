//! The law that the paper's tables are fitted by.

use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::report::document::Document;
use crate::report::plot::{Axis, Figure, Layer, Measure};
use crate::report::published::Published;
use crate::report::shown::stated;
use crate::reproduce::WinfieldTan;
use crate::units::{Quantity, System, significant};

/// Speeds that the law is shown at, m/s and mph, the same to 3 %: what the paper's flights pass
/// through.
const METRES_PER_SECOND: [f64; 4] = [30.0, 40.0, 50.0, 65.0];
const MILES_PER_HOUR: [f64; 4] = [70.0, 90.0, 110.0, 145.0];

/// The slowest and the fastest ball of the paper's flights, m/s.
const FLOWN: [f64; 2] = [25.0, 68.0];

/// Spin ratios that the law is shown at.
const SPIN_RATIOS: [f64; 6] = [0.03, 0.06, 0.10, 0.15, 0.20, 0.30];

/// The uncertainty that a printed distance is given in the calibration, m: 0.05 yd.
const WEIGHT: f64 = 0.04572;

/// The most spin of the paper's flights, rad/s: loft 17.14° at 110 mph.
const MOST_SPIN: f64 = 450.0;

pub(super) fn law(document: &mut Document, found: &WinfieldTan, shown: Published) {
    let fit = &found.fitted.law;
    let left = (fit.statistics.chi_square / fit.statistics.degrees_of_freedom as f64).sqrt();
    document.heading("The law");
    document.paragraph(format!(
        "With x = s √(v/50 m/s) and u = (v − 50 m/s)/20 m/s, C_D = (cd0 + cd1 x + cd2 x² + cd3 \
         x³)(1 + cd_v1 u + cd_v2 u²) and C_L = \
         (cl_hill x/(x + cl_half) + cl_slope x)/(1 + ((v − cl_speed)/cl_width)²): {} coefficients, \
         calibrated to {} printed numbers with \
         the spin decay held at {} /s. The weights ({}, 0.02°) are finer than the law can follow: \
         the residuals are \
         {left:.1} times as large, and the standard errors here are scaled by that factor.",
        fit.estimates.len(),
        fit.remainders.len(),
        significant(found.setup.aero.spin_decay, 3),
        given(shown.length_number(WEIGHT), shown.length_unit()),
    ));
    let rows = fit.estimates.iter().map(|estimate| {
        let parameter = estimate.parameter;
        let show = |value: Option<f64>| {
            value.map_or("–".into(), |value| stated(parameter, value, shown.system))
        };
        let unit = shown.system.unit(parameter.unit);
        let size = parameter.quantity.size_of(unit).unwrap_or(1.0);
        let error = estimate
            .standard_error
            .map(|error| given(error * left / size, unit));
        vec![
            show(found.setup.value(parameter)),
            show(Some(estimate.value)),
            error.unwrap_or("–".into()),
            parameter.name.into(),
        ]
    });
    document.table(
        &[
            "in the preset",
            "fitted again",
            "standard error",
            "coefficient",
        ],
        rows,
    );
    let unit = shown.system.unit("m/s");
    let size = Quantity::SPEED.size_of(unit).unwrap_or(f64::NAN);
    let [slowest, fastest] = FLOWN.map(|speed| significant(speed / size, 2));
    document.paragraph(format!(
        "It is valid for the speeds and spins of the paper's flights, {slowest} < v < {fastest} \
         {unit}, 0.02 < s < 0.35 and spins up to {MOST_SPIN} rad/s, where \
         it is shown; outside, it is smooth, positive and rises with spin, but is not supported by \
         data.",
    ));
    let speeds = match shown.system {
        System::Metric => METRES_PER_SECOND,
        System::Us => MILES_PER_HOUR,
    };
    let head = |of: &str| {
        speeds.map(|v| {
            if v == speeds[0] {
                format!("{of} at {v} {unit}")
            } else {
                format!("{v}")
            }
        })
    };
    let heads: Vec<String> = ["s".to_owned()]
        .into_iter()
        .chain(head("C_D"))
        .chain(head("C_L"))
        .collect();
    document.table(
        &heads.iter().map(String::as_str).collect::<Vec<_>>(),
        SPIN_RATIOS.map(|s| {
            let at = speeds
                .map(|v| is_flown(found, s, v * size).then(|| coefficients(found, s, v * size)));
            let cell =
                |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.3}"));
            let drag = at.iter().map(|c| cell(c.map(|(drag, _)| drag)));
            let lift = at.iter().map(|c| cell(c.map(|(_, lift)| lift)));
            std::iter::once(format!("{s:.2}"))
                .chain(drag)
                .chain(lift)
                .collect()
        }),
    );
    for (name, title, is_drag) in [
        ("drag", "Drag coefficient", true),
        ("lift", "Lift coefficient", false),
    ] {
        let axes = (
            Axis::linear(Measure::plain("spin ratio")),
            Axis::linear(Measure::plain(title)),
        );
        let mut figure = Figure::new(
            format!("law-{name}"),
            format!("{title} of the recovered law"),
            axes.0,
            axes.1,
        );
        for (i, speed) in speeds.into_iter().enumerate() {
            let flown = (1..=35)
                .map(|k| f64::from(k) * 0.01)
                .filter(|s| is_flown(found, *s, speed * size));
            let points = flown.map(|s| {
                let (drag, lift) = coefficients(found, s, speed * size);
                [s, if is_drag { drag } else { lift }]
            });
            figure = figure.with(Layer::line(format!("{speed} {unit}"), i, points.collect()));
        }
        document.figure(figure);
    }
}

/// A number to two digits, with its unit.
fn given(number: f64, unit: &str) -> String {
    format!("{} {unit}", significant(number, 2))
        .trim_end()
        .to_owned()
}

/// Whether a ball of the paper has as much spin.
fn is_flown(found: &WinfieldTan, spin_ratio: f64, speed: f64) -> bool {
    spin_ratio * speed / found.setup.ball.radius <= MOST_SPIN
}

fn coefficients(found: &WinfieldTan, spin_ratio: f64, speed: f64) -> (f64, f64) {
    let radius = found.setup.ball.radius;
    let per_speed = found.setup.air.density * 2.0 * radius / found.setup.air.viscosity;
    let c = found.setup.law.coefficients(Stream::new(
        spin_ratio * speed / radius,
        speed,
        radius,
        per_speed,
    ));
    (c.drag, c.lift)
}

pub(super) fn decay(document: &mut Document, found: &WinfieldTan) {
    let (rate, error) = found.fitted.decay;
    document.heading("The spin decay");
    document.paragraph(format!(
        "The paper takes a decay constant of 0.6 to 0.7, without a unit; later measurements give \
         about 4 % per second (0.03–0.045 /s). Fitted together with the \
         coefficients, its own tables give δ = {} ± {} /s (one standard error, scaled by the \
         residuals of the fit). With the rate held at given values, \
         and everything else fitted again, the residuals are:",
        significant(rate, 2),
        significant(error, 2),
    ));
    let least = found
        .fitted
        .profile
        .iter()
        .map(|decay| decay.sum)
        .fold(f64::INFINITY, f64::min);
    document.table(
        &["δ, 1/s", "sum of squares", "relative to the smallest"],
        found.fitted.profile.iter().map(|decay| {
            vec![
                format!("{}", decay.rate),
                format!("{:.1}", decay.sum),
                format!("{:.2}", decay.sum / least),
            ]
        }),
    );
    let axes = (
        Axis::linear(Measure::new("spin decay", Quantity::RATE, "1/s")),
        Axis::linear(Measure::plain("sum of squares")),
    );
    let points = found
        .fitted
        .profile
        .iter()
        .map(|decay| [decay.rate, decay.sum])
        .collect();
    document.figure(
        Figure::new(
            "spin-decay",
            "Residuals of the tables at given rates of spin decay",
            axes.0,
            axes.1,
        )
        .with(Layer::line("everything else fitted", 0, points)),
    );
}
