use super::dimension::Dimension;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// A unit symbol.
pub(super) struct Symbol {
    /// How it is written; the first is the usual one.
    pub names: &'static [&'static str],
    /// Its SI size.
    pub size: f64,
    pub dimension: Dimension,
    /// Where its zero lies, SI, if that is not zero.
    pub zero: Option<f64>,
}

/// Every unit symbol.
pub(super) static SYMBOLS: LazyLock<Vec<Symbol>> = LazyLock::new(symbols);

/// The unit symbol of this name.
pub(super) fn symbol(name: &str) -> Option<&'static Symbol> {
    SYMBOLS.iter().find(|known| known.names.contains(&name))
}

/// The sizes are definitions (SI brochure, 9th edition; the yard and the pound of 1959, from which inch, foot, mile and ounce follow; mercury of
/// 13 595.1 kg/m³ at standard gravity), so that nothing is rounded but the last bit.
fn symbols() -> Vec<Symbol> {
    use Dimension as D;
    let symbol = |names, size, dimension| Symbol { names, size, dimension, zero: None };
    let scale = |names, size, zero| Symbol { names, size, dimension: D::TEMPERATURE, zero: Some(zero) };
    let speed = D::LENGTH.times(D::TIME, -1);
    let force = speed.times(D::MASS, 1).times(D::TIME, -1);
    let pressure = force.times(D::LENGTH, -2);
    let viscosity = D::MASS.times(D::LENGTH, -1).times(D::TIME, -1);
    vec![
        symbol(&["1"], 1.0, D::NONE),
        symbol(&["%"], 1e-2, D::NONE),
        symbol(&["m", "metre", "metres", "meter", "meters"], 1.0, D::LENGTH),
        symbol(&["um", "µm", "μm"], 1e-6, D::LENGTH),
        symbol(&["mm"], 1e-3, D::LENGTH),
        symbol(&["cm"], 1e-2, D::LENGTH),
        symbol(&["km"], 1e3, D::LENGTH),
        symbol(&["in", "inch", "inches"], 0.0254, D::LENGTH),
        symbol(&["ft", "foot", "feet"], 0.3048, D::LENGTH),
        symbol(&["yd", "yard", "yards"], 0.9144, D::LENGTH),
        symbol(&["mi", "mile", "miles"], 1609.344, D::LENGTH),
        symbol(&["L", "l"], 1e-3, D::NONE.times(D::LENGTH, 3)),
        symbol(&["kg"], 1.0, D::MASS),
        symbol(&["g", "gram", "grams"], 1e-3, D::MASS),
        symbol(&["mg"], 1e-6, D::MASS),
        symbol(&["oz"], 0.028_349_523_125, D::MASS),
        symbol(&["lb", "lbs"], 0.453_592_37, D::MASS),
        symbol(&["s", "sec", "second", "seconds"], 1.0, D::TIME),
        symbol(&["ms"], 1e-3, D::TIME),
        symbol(&["min", "minute", "minutes"], 60.0, D::TIME),
        symbol(&["h", "hour", "hours"], 3600.0, D::TIME),
        symbol(&["rad", "radian", "radians"], 1.0, D::ANGLE),
        symbol(&["mrad"], 1e-3, D::ANGLE),
        symbol(&["deg", "°", "degree", "degrees"], TAU / 360.0, D::ANGLE),
        symbol(&["rev"], TAU, D::ANGLE),
        symbol(&["rpm"], TAU / 60.0, D::ANGLE.times(D::TIME, -1)),
        symbol(&["mph"], 0.44704, speed),
        symbol(&["kph", "kmh"], 1.0 / 3.6, speed),
        symbol(&["kn", "knot", "knots"], 1852.0 / 3600.0, speed),
        symbol(&["N"], 1.0, force),
        symbol(&["Pa"], 1.0, pressure),
        symbol(&["hPa"], 100.0, pressure),
        symbol(&["kPa"], 1000.0, pressure),
        symbol(&["bar"], 1e5, pressure),
        symbol(&["mbar", "mb"], 100.0, pressure),
        symbol(&["mmHg"], 133.322_387_415, pressure),
        symbol(&["inHg"], 3_386.388_640_341, pressure),
        symbol(&["K", "kelvin"], 1.0, D::TEMPERATURE),
        scale(&["degC", "°C", "celsius"], 1.0, 273.15),
        scale(&["degF", "°F", "fahrenheit"], 5.0 / 9.0, 459.67 * 5.0 / 9.0),
        symbol(&["P"], 0.1, viscosity),
        symbol(&["cP"], 1e-3, viscosity),
    ]
}

#[cfg(test)]
mod tests {
    use super::{SYMBOLS, symbol};
    use uom::si::f64::{
        Angle, AngularVelocity, DynamicViscosity, Force, Length, Mass, Pressure, Ratio, TemperatureInterval,
        ThermodynamicTemperature, Time, Velocity, Volume,
    };
    use uom::si::{
        angle, angular_velocity, dynamic_viscosity, force, length, mass, pressure, ratio, temperature_interval,
        thermodynamic_temperature, time, velocity, volume,
    };

    #[test]
    fn independent_sizes_are_those_of_uom() {
        let sizes = [
            ("1", Ratio::new::<ratio::ratio>(1.0).value),
            ("%", Ratio::new::<ratio::percent>(1.0).value),
            ("m", Length::new::<length::meter>(1.0).value),
            ("um", Length::new::<length::micrometer>(1.0).value),
            ("mm", Length::new::<length::millimeter>(1.0).value),
            ("cm", Length::new::<length::centimeter>(1.0).value),
            ("km", Length::new::<length::kilometer>(1.0).value),
            ("in", Length::new::<length::inch>(1.0).value),
            ("ft", Length::new::<length::foot>(1.0).value),
            ("yd", Length::new::<length::yard>(1.0).value),
            ("mi", Length::new::<length::mile>(1.0).value),
            ("L", Volume::new::<volume::liter>(1.0).value),
            ("kg", Mass::new::<mass::kilogram>(1.0).value),
            ("g", Mass::new::<mass::gram>(1.0).value),
            ("mg", Mass::new::<mass::milligram>(1.0).value),
            // uom rounds the pound and the ounce to seven digits; its grain is exact, and both are whole numbers of it
            ("oz", 437.5 * Mass::new::<mass::grain>(1.0).value),
            ("lb", 7000.0 * Mass::new::<mass::grain>(1.0).value),
            ("s", Time::new::<time::second>(1.0).value),
            ("ms", Time::new::<time::millisecond>(1.0).value),
            ("min", Time::new::<time::minute>(1.0).value),
            ("h", Time::new::<time::hour>(1.0).value),
            ("rad", Angle::new::<angle::radian>(1.0).value),
            ("mrad", Angle::new::<angle::radian>(1e-3).value),
            ("deg", Angle::new::<angle::degree>(1.0).value),
            ("rev", Angle::new::<angle::revolution>(1.0).value),
            ("rpm", AngularVelocity::new::<angular_velocity::revolution_per_minute>(1.0).value),
            ("mph", Velocity::new::<velocity::mile_per_hour>(1.0).value),
            ("kph", Velocity::new::<velocity::kilometer_per_hour>(1.0).value),
            ("kn", Velocity::new::<velocity::knot>(1.0).value),
            ("N", Force::new::<force::newton>(1.0).value),
            ("Pa", Pressure::new::<pressure::pascal>(1.0).value),
            ("hPa", Pressure::new::<pressure::hectopascal>(1.0).value),
            ("kPa", Pressure::new::<pressure::kilopascal>(1.0).value),
            ("bar", Pressure::new::<pressure::bar>(1.0).value),
            ("mbar", Pressure::new::<pressure::millibar>(1.0).value),
            // uom rounds these to seven digits
            ("mmHg", 13_595.1 * 9.80665 * Length::new::<length::millimeter>(1.0).value),
            ("inHg", 13_595.1 * 9.80665 * Length::new::<length::inch>(1.0).value),
            ("K", TemperatureInterval::new::<temperature_interval::kelvin>(1.0).value),
            ("degC", TemperatureInterval::new::<temperature_interval::degree_celsius>(1.0).value),
            ("degF", TemperatureInterval::new::<temperature_interval::degree_fahrenheit>(1.0).value),
            ("P", DynamicViscosity::new::<dynamic_viscosity::poise>(1.0).value),
            ("cP", DynamicViscosity::new::<dynamic_viscosity::centipoise>(1.0).value),
        ];
        assert_eq!(sizes.len(), SYMBOLS.len(), "every symbol is here");
        for (name, theirs) in sizes {
            let ours = symbol(name).unwrap().size;
            assert!((ours - theirs).abs() <= f64::EPSILON * theirs, "{name}: {ours:e} against {theirs:e}");
        }
    }

    #[test]
    fn independent_zeros_are_those_of_uom() {
        let zeros = [
            ("degC", ThermodynamicTemperature::new::<thermodynamic_temperature::degree_celsius>(0.0).value),
            ("degF", ThermodynamicTemperature::new::<thermodynamic_temperature::degree_fahrenheit>(0.0).value),
        ];
        for (name, theirs) in zeros {
            let ours = symbol(name).unwrap().zero.unwrap();
            assert!((ours - theirs).abs() <= f64::EPSILON * theirs, "{name}: {ours:e} against {theirs:e}");
        }
        assert_eq!(SYMBOLS.iter().filter(|symbol| symbol.zero.is_some()).count(), zeros.len());
    }
}
