//! Searches with and without the noise of the while-loop.

use crate::report::document::{Document, DocumentTable};
use crate::report::plot::{Figure, Hue, Layer, Shape};
use crate::report::published::{PaperUnits, angles};
use crate::reproduce::{DeliveryCarry, LandingDefinition, Mae494, SearchMethod, Searches};
use crate::statistics::median;
use crate::units::{Quantity, System};

/// A search counts as successful if its carry is at most this much below the best carry, m.
const FOUND: f64 = 0.01;

pub(super) fn searches(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let best = found.optimum.exact();
    let count = found
        .noise
        .searches
        .first()
        .map_or(0, |searches| searches.ends.len());
    document.heading("Searches with its flight loop");
    document.paragraph(format!(
        "All methods search from the same {count} starts in the report's ranges; the ball flies at \
         each start. The table counts the searches that end within {} of \
         the best carry, {}. A miss is the best carry minus the carry at the end of a search, \
         both with the smooth landing. A flight with exact derivatives counts as one flight. \
         L-BFGS is \
         that of argmin, with the line search of Moré and Thuente; since it has no bounds, it \
         searches over u, with x = middle + half the width · sin u. \
         Its carry is taken as 0 where a drive does not fly.",
        Quantity::LENGTH.read_off(
            FOUND,
            if units.length_unit() == "yd" {
                "in"
            } else {
                "mm"
            }
        ),
        units.length(best.carry),
    ));
    let rows = found.noise.searches.iter().map(|searches| {
        let losses = searches.losses(best.carry);
        let worst = losses.last().copied().unwrap_or_default();
        let successful = losses.iter().filter(|loss| **loss <= FOUND).count();
        vec![
            format!("{successful} of {count}"),
            units.length(median(&losses).unwrap_or_default()),
            units.length(worst),
            format!("{:.0}", searches.flights() as f64 / count.max(1) as f64),
            landing(searches.landing).into(),
            method(searches.method).into(),
        ]
    });
    let table = DocumentTable::new(
        [
            "found",
            "median miss",
            "worst miss",
            "flights each",
            "landing",
            "method",
        ],
        rows,
    );
    document.add(table.right(0..4));
    document.figure(ends(&found.noise.searches, &best, units.system));
}

fn landing(landing: LandingDefinition) -> &'static str {
    match landing {
        LandingDefinition::Overshot => "the report's loop",
        LandingDefinition::Interpolated => "loop, interpolated",
        LandingDefinition::Smooth => "smooth",
    }
}

fn method(method: SearchMethod) -> &'static str {
    match method {
        SearchMethod::LimitedMemory => "L-BFGS, differences",
        SearchMethod::LimitedMemoryExact => "L-BFGS, exact gradients",
        SearchMethod::QuasiNewton => "longdrive without Hessians, differences",
        SearchMethod::Exact => "longdrive, exact gradients and Hessians",
    }
}

fn ends(searches: &[Searches], best: &DeliveryCarry, system: System) -> Figure {
    let mut figure = Figure::new(
        system,
        "ends",
        "Where searches from the same starts end",
        angles("loft"),
        angles("attack angle"),
    )
    .noted("If a search does not move, the mark of its end hides the mark of its start.");
    if let Some(any) = searches.first() {
        let points = any
            .ends
            .iter()
            .map(|end| [end.start.loft, end.start.attack_angle])
            .collect();
        figure = figure.with(Layer::new("starts", Hue::Faint, Shape::Dots(points)));
    }
    let drawn = [
        (LandingDefinition::Overshot, SearchMethod::LimitedMemory, 1),
        (LandingDefinition::Overshot, SearchMethod::QuasiNewton, 2),
    ];
    for (landing, by, hue) in drawn {
        for searches in searches
            .iter()
            .filter(|searches| (searches.landing, searches.method) == (landing, by))
        {
            let points = searches
                .ends
                .iter()
                .map(|search| [search.end.loft, search.end.attack_angle])
                .collect();
            figure = figure.with(Layer::dots(
                format!("{} on the report's loop", method(by)),
                hue,
                points,
            ));
        }
    }
    figure.with(Layer::new(
        "the optimum",
        Hue::Series(0),
        Shape::Mark([best.loft, best.attack_angle]),
    ))
}
