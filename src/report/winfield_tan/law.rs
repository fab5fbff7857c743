//! The law fitted to the paper's tables.

use crate::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use crate::atmosphere::AirState;
use crate::report::document::{Document, DocumentTable};
use crate::report::plot::{Axis, Figure, Layer, NamedQuantity};
use crate::report::published::{PaperUnits, SPEED};
use crate::report::shown::{NONE, stated};
use crate::reproduce::{FittedNumber, WinfieldTan};
use crate::units::{DisplayUnit, Quantity, System, significant, typed};

/// Speeds in the table of coefficients, m/s. They lie within [`FLOWN`].
const METRES_PER_SECOND: [f64; 4] = [30.0, 40.0, 50.0, 65.0];
/// Speeds in the table of coefficients, mph. They agree with `METRES_PER_SECOND` within 5 %.
const MILES_PER_HOUR: [f64; 4] = [70.0, 90.0, 110.0, 145.0];

/// The lowest and the highest ball speed in the paper's flights, m/s.
const FLOWN: [f64; 2] = [25.0, 68.0];

/// Spin ratios in the table of coefficients.
const SPIN_RATIOS: [f64; 6] = [0.03, 0.06, 0.10, 0.15, 0.20, 0.30];

/// Standard uncertainty of a printed distance in the calibration, m: 0.05 yd.
const CARRY_SIGMA: f64 = 0.04572;

/// Largest spin of the paper's flights, rad/s. It belongs to loft 17.14° and club speed 110 mph.
const MOST_SPIN: f64 = 450.0;

/// Adds the law to a document: its formula, its coefficients for some speeds and spin ratios, and
/// plots.
pub(super) fn law(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    document.heading("The law");
    fit(document, found, units);
    let (unit, size) = (units.system.unit(SPEED.unit), SPEED.size_in(units.system));
    let [slowest, fastest] = FLOWN.map(|speed| significant(speed / size, 2));
    document.paragraph(format!(
        "It is valid for the speeds and spins of the paper's flights, {slowest} < v < {fastest} \
         {}, 0.02 < s < 0.35 and spins up to {MOST_SPIN} rad/s, where it is shown; outside, it is \
         smooth, positive and rises with spin, but is not supported by data.",
        unit
    ));
    values(document, found, units.system);
    for (name, title, is_drag) in [
        ("drag", "Drag coefficient", true),
        ("lift", "Lift coefficient", false),
    ] {
        let mut figure = Figure::new(
            units.system,
            format!("law-{name}"),
            format!("{title} of the recovered law"),
            Axis::linear(NamedQuantity::plain("spin ratio")),
            Axis::linear(NamedQuantity::plain(title)),
        );
        for (i, number) in speeds(units.system).into_iter().enumerate() {
            let speed = number * size;
            let spin_ratios = (1..=35).map(|k| f64::from(k) * 0.01);
            let points = spin_ratios.filter(|s| is_flown(found, *s, speed)).map(|s| {
                let Coefficients { drag, lift } = coefficients(found, s, speed);
                [s, if is_drag { drag } else { lift }]
            });
            let name = format!("{number} {unit}");
            figure = figure.with(Layer::line(name, i, points.collect()));
        }
        document.figure(figure);
    }
}

/// The speeds in the table of coefficients, in the unit of the system.
fn speeds(system: System) -> [f64; 4] {
    match system {
        System::Metric => METRES_PER_SECOND,
        System::Us => MILES_PER_HOUR,
    }
}

/// Adds the formula to a document, with the coefficients of the preset and of a new fit.
fn fit(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    let fit = &found.fitted.law;
    let scale = (fit.statistics.chi_square / fit.statistics.degrees_of_freedom as f64).sqrt();
    document.paragraph(format!(
        "With x = s √(v/50 m/s) and u = (v − 50 m/s)/20 m/s, C_D = (cd0 + cd1 x + cd2 x² + cd3 \
         x³)(1 + cd_v1 u + cd_v2 u²) and C_L = \
         (cl_hill x/(x + cl_half) + cl_slope x)/(1 + ((v − cl_speed)/cl_width)²): {} coefficients, \
         calibrated to {} printed numbers with \
         the spin decay held at {} /s. The weights ({}, 0.02°) are finer than the law can follow: \
         the residuals are \
         {scale:.1} times as large, and the standard errors here are scaled by that factor.",
        fit.estimates.len(),
        fit.residuals.len(),
        significant(found.setup.aero.spin_decay, 3),
        typed(
            &significant(units.length_number(CARRY_SIGMA), 2),
            units.length_unit()
        ),
    ));
    let rows = fit.estimates.iter().map(|estimate| {
        let parameter = estimate.parameter;
        let show = |value: Option<f64>| {
            value.map_or(NONE.into(), |value| stated(parameter, value, units.system))
        };
        let unit = units.system.unit(parameter.unit);
        let size = DisplayUnit::from(parameter).size_in(units.system);
        let error = estimate
            .standard_error
            .map(|error| typed(&significant(error * scale / size, 2), unit));
        vec![
            show(found.setup.value(parameter)),
            show(Some(estimate.value)),
            error.unwrap_or(NONE.into()),
            parameter.name.into(),
        ]
    });
    let head = [
        "in the preset",
        "fitted again",
        "standard error",
        "coefficient",
    ];
    document.add(DocumentTable::new(head, rows).right(0..3));
}

/// Adds drag and lift to a document, by spin ratio and speed.
fn values(document: &mut Document, found: &WinfieldTan, system: System) {
    let (speeds, size) = (speeds(system), SPEED.size_in(system));
    let unit = system.unit(SPEED.unit);
    let heads = |of: &str| {
        speeds.map(|number| {
            if number == speeds[0] {
                format!("{of} at {number} {unit}")
            } else {
                format!("{number}")
            }
        })
    };
    let heads: Vec<String> = ["s".to_owned()]
        .into_iter()
        .chain(heads("C_D"))
        .chain(heads("C_L"))
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let rows = SPIN_RATIOS.map(|s| {
        let at = speeds.map(|number| {
            let speed = number * size;
            is_flown(found, s, speed).then(|| coefficients(found, s, speed))
        });
        let cell = |value: Option<f64>| value.map_or(NONE.into(), |value| format!("{value:.3}"));
        let drag = at.iter().map(|c| cell(c.map(|c| c.drag)));
        let lift = at.iter().map(|c| cell(c.map(|c| c.lift)));
        std::iter::once(format!("{s:.2}"))
            .chain(drag)
            .chain(lift)
            .collect()
    });
    let numbers = 0..heads.len();
    document.add(DocumentTable::new(heads, rows).right(numbers));
}

/// True if the spin is at most the largest spin of the paper's flights.
fn is_flown(found: &WinfieldTan, spin_ratio: f64, speed: f64) -> bool {
    spin_ratio * speed / found.setup.ball.radius <= MOST_SPIN
}

fn coefficients(found: &WinfieldTan, spin_ratio: f64, speed: f64) -> Coefficients<f64> {
    let radius = found.setup.ball.radius;
    let per_speed = AirState::of(&found.setup.air).reynolds_per_speed(radius);
    found.setup.law.coefficients(Stream::new(
        spin_ratio * speed / radius,
        speed,
        radius,
        per_speed,
    ))
}

pub(super) fn decay(document: &mut Document, found: &WinfieldTan, system: System) {
    let FittedNumber {
        value: rate,
        standard_uncertainty: error,
    } = found.fitted.decay;
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
    let table = DocumentTable::new(
        ["δ, 1/s", "sum of squares", "relative to the smallest"],
        found.fitted.profile.iter().map(|decay| {
            vec![
                format!("{}", decay.rate),
                format!("{:.1}", decay.sum),
                format!("{:.2}", decay.sum / least),
            ]
        }),
    );
    document.add(table.right(0..3));
    let axes = (
        Axis::linear(NamedQuantity::new("spin decay", Quantity::RATE, "1/s")),
        Axis::linear(NamedQuantity::plain("sum of squares")),
    );
    let points = found
        .fitted
        .profile
        .iter()
        .map(|decay| [decay.rate, decay.sum])
        .collect();
    document.figure(
        Figure::new(
            system,
            "spin-decay",
            "Residuals of the tables at given rates of spin decay",
            axes.0,
            axes.1,
        )
        .with(Layer::line("everything else fitted", 0, points)),
    );
}
