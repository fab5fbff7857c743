//! The section about the noise of the while-loop.

use crate::report::document::{Document, DocumentTable};
use crate::report::plot::{Axis, Figure, Layer, NamedQuantity};
use crate::report::published::{PaperUnits, angles};
use crate::reproduce::{Landings, Noise, Slopes};
use crate::units::{Digits, Quantity, System, significant};

pub(super) fn noise(document: &mut Document, noise: &Noise, units: PaperUnits) {
    document.heading("The noise of its flight loop");
    document.paragraph(format!(
        "The report's flight loop stops at the first step of {} s that ends below the ground. \
         Carry as a function of loft is then a \
         sawtooth: around loft 10°, attack angle 0° there is a jump every {}° of loft, {} high. \
         This is not random noise but a bias: a small \
         difference lies between two jumps, where the number of steps does not change, and gives \
         the slope of carry at a fixed time, not that \
         at landing. Its sign is wrong at {} of the {} lofts below. Linear interpolation between \
         the last two steps of the loop removes the jumps.",
        noise.step,
        significant(noise.teeth.width.to_degrees(), 3),
        Quantity::LENGTH.text(noise.teeth.height, units.length_unit(), Digits::Difference),
        noise.wrong_signs,
        noise.slopes.len(),
    ));
    document.figure(zoomed(&noise.zoom, units.system));
    document.paragraph(format!(
        "Slopes of carry by loft at attack angle 0°. Those of the loop are finite differences \
         with an increment of {} rad, as in MATLAB's fmincon:",
        significant(noise.difference, 3)
    ));
    add_slopes(document, noise, units);
    document.figure(slopes(&noise.slopes, units.system));
    document.paragraph(
        "A shorter time step does not help. The loop's finite differences at loft 10°, attack \
         angle 0° are:",
    );
    let rows = noise.shorter_steps.iter().map(|at| {
        let slope = units.per_radian(at.overshot);
        vec![format!("{} s", at.step), slope]
    });
    document.add(DocumentTable::new(["time step", "loop"], rows).right(0..2));
    document.paragraph(
        "Longer differences reach over several jumps, but have an error from the curvature \
         instead. The same loft and attack angle, with the original time step:",
    );
    add_longer_differences(document, noise, units);
}

fn add_slopes(document: &mut Document, noise: &Noise, units: PaperUnits) {
    let per_radian = |slope: f64| units.per_radian(slope);
    let rows = noise.slopes.iter().map(|slopes| {
        vec![
            format!("{:.0}°", slopes.loft.to_degrees()),
            per_radian(slopes.exact),
            per_radian(slopes.at_fixed_time),
            per_radian(slopes.overshot),
            per_radian(slopes.interpolated),
            if slopes.sign_is_wrong {
                "the loop's sign is wrong"
            } else {
                ""
            }
            .into(),
        ]
    });
    let table = DocumentTable::new(
        [
            "loft",
            "exact",
            "exact, at fixed time",
            "loop",
            "loop, interpolated",
            "",
        ],
        rows,
    );
    document.add(table.right(0..5));
}

/// Adds a table of finite differences with larger steps in the loft.
fn add_longer_differences(document: &mut Document, noise: &Noise, units: PaperUnits) {
    let rows = noise.longer_differences.iter().map(|slopes| {
        vec![
            format!("{} rad", significant(slopes.difference, 3)),
            units.per_radian(slopes.overshot),
            units.per_radian(slopes.interpolated),
            units.per_radian(slopes.smooth),
        ]
    });
    let table = DocumentTable::new(
        ["difference", "loop", "loop, interpolated", "smooth landing"],
        rows,
    );
    document.add(table.right(0..4));
}

fn zoomed(zoom: &[Landings], system: System) -> Figure {
    let points = |carry: fn(&Landings) -> f64| zoom.iter().map(|at| [at.loft, carry(at)]).collect();
    let carry = Axis::linear(NamedQuantity::new("carry", Quantity::LENGTH, "m"));
    Figure::new(
        system,
        "teeth",
        "Carry at high zoom, attack angle 0°",
        angles("loft"),
        carry,
    )
    .with(Layer::line(
        "the report's loop",
        1,
        points(|at| at.overshot),
    ))
    .with(Layer::line(
        "the loop, interpolated",
        2,
        points(|at| at.interpolated),
    ))
    .with(Layer::line("smooth landing", 0, points(|at| at.smooth)))
    .noted(
        "The loop also has the error of its Euler steps: when it is interpolated, it is \
                smooth but does not agree with the exact flight.",
    )
}

fn slopes(slopes: &[Slopes], system: System) -> Figure {
    let points = |slope: fn(&Slopes) -> f64| {
        slopes
            .iter()
            .map(|at| [at.loft, slope(at).to_radians()])
            .collect()
    };
    let slope = Axis::linear(NamedQuantity::new(
        "carry per degree of loft",
        Quantity::LENGTH,
        "m",
    ));
    Figure::new(
        system,
        "slopes",
        "d carry/d loft over the loft, attack angle 0°",
        angles("loft"),
        slope,
    )
    .with(Layer::line(
        "exact, at fixed time",
        3,
        points(|at| at.at_fixed_time),
    ))
    .with(Layer::dots(
        "differences of the report's loop",
        1,
        points(|at| at.overshot),
    ))
    .with(Layer::line("exact", 0, points(|at| at.exact)))
    .with(Layer::dots(
        "differences of the loop, interpolated",
        2,
        points(|at| at.interpolated),
    ))
}
