use super::dimension::Dimension;
use std::sync::LazyLock;
use uom::si::f64::{Angle, Force, Length, Mass, Pressure, Ratio, Time, Velocity, Volume};
use uom::si::{angle, force, length, mass, pressure, ratio, time, velocity, volume};

/// A unit symbol.
pub(super) struct Symbol {
    /// How it is written; the first is the usual one.
    pub names: &'static [&'static str],
    /// Its SI size.
    size: f64,
    pub dimension: Dimension,
}

/// Every unit symbol.
pub(super) static SYMBOLS: LazyLock<Vec<Symbol>> = LazyLock::new(symbols);

/// The SI size and the dimension of one unit symbol.
pub(super) fn symbol_size(symbol: &str) -> Option<(f64, Dimension)> {
    let known = SYMBOLS.iter().find(|known| known.names.contains(&symbol))?;
    Some((known.size, known.dimension))
}

fn symbols() -> Vec<Symbol> {
    use Dimension as D;
    let symbol = |names, size, dimension| Symbol { names, size, dimension };
    // uom rounds the pound and the ounce to seven digits; its grain is exact, and both are whole numbers of it
    let grain = || Mass::new::<mass::grain>(1.0).value;
    let turn = Angle::new::<angle::revolution>(1.0).value;
    let speed = D::LENGTH.times(D::TIME, -1);
    let force = speed.times(D::MASS, 1).times(D::TIME, -1);
    vec![
        symbol(&["1"], 1.0, D::NONE),
        symbol(&["%"], Ratio::new::<ratio::percent>(1.0).value, D::NONE),
        symbol(&["m", "metre", "metres", "meter", "meters"], 1.0, D::LENGTH),
        symbol(&["um", "µm", "μm"], Length::new::<length::micrometer>(1.0).value, D::LENGTH),
        symbol(&["mm"], Length::new::<length::millimeter>(1.0).value, D::LENGTH),
        symbol(&["cm"], Length::new::<length::centimeter>(1.0).value, D::LENGTH),
        symbol(&["km"], Length::new::<length::kilometer>(1.0).value, D::LENGTH),
        symbol(&["in", "inch", "inches"], Length::new::<length::inch>(1.0).value, D::LENGTH),
        symbol(&["ft", "foot", "feet"], Length::new::<length::foot>(1.0).value, D::LENGTH),
        symbol(&["yd", "yard", "yards"], Length::new::<length::yard>(1.0).value, D::LENGTH),
        symbol(&["mi", "mile", "miles"], Length::new::<length::mile>(1.0).value, D::LENGTH),
        symbol(&["L", "l"], Volume::new::<volume::liter>(1.0).value, D::NONE.times(D::LENGTH, 3)),
        symbol(&["kg"], 1.0, D::MASS),
        symbol(&["g", "gram", "grams"], Mass::new::<mass::gram>(1.0).value, D::MASS),
        symbol(&["mg"], Mass::new::<mass::milligram>(1.0).value, D::MASS),
        symbol(&["oz"], 437.5 * grain(), D::MASS),
        symbol(&["lb", "lbs"], 7000.0 * grain(), D::MASS),
        symbol(&["s", "sec", "second", "seconds"], 1.0, D::TIME),
        symbol(&["ms"], Time::new::<time::millisecond>(1.0).value, D::TIME),
        symbol(&["min", "minute", "minutes"], Time::new::<time::minute>(1.0).value, D::TIME),
        symbol(&["h", "hour", "hours"], Time::new::<time::hour>(1.0).value, D::TIME),
        symbol(&["rad", "radian", "radians"], 1.0, D::ANGLE),
        symbol(&["mrad"], 1e-3, D::ANGLE),
        symbol(&["deg", "°", "degree", "degrees"], Angle::new::<angle::degree>(1.0).value, D::ANGLE),
        symbol(&["rev"], Angle::new::<angle::revolution>(1.0).value, D::ANGLE),
        symbol(&["rpm"], turn / 60.0, D::ANGLE.times(D::TIME, -1)),
        symbol(&["mph"], Velocity::new::<velocity::mile_per_hour>(1.0).value, speed),
        symbol(&["kph", "kmh"], Velocity::new::<velocity::kilometer_per_hour>(1.0).value, speed),
        symbol(&["kn", "knot", "knots"], Velocity::new::<velocity::knot>(1.0).value, speed),
        symbol(&["N"], Force::new::<force::newton>(1.0).value, force),
        symbol(&["Pa"], Pressure::new::<pressure::pascal>(1.0).value, force.times(D::LENGTH, -2)),
        symbol(&["P"], 0.1, D::MASS.times(D::LENGTH, -1).times(D::TIME, -1)),
        symbol(&["cP"], 1e-3, D::MASS.times(D::LENGTH, -1).times(D::TIME, -1)),
    ]
}
