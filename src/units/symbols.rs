use super::dimension::Dimension;
use uom::si::f64::{Angle, Force, Length, Mass, Pressure, Ratio, Time, Velocity, Volume};
use uom::si::{angle, force, length, mass, pressure, ratio, time, velocity, volume};

/// The SI size and the dimension of one unit symbol.
pub(super) fn symbol_size(symbol: &str) -> Option<(f64, Dimension)> {
    use Dimension as D;
    // uom rounds the pound and the ounce to seven digits; its grain is exact, and both are whole numbers of it
    let grain = || Mass::new::<mass::grain>(1.0).value;
    let speed = D::LENGTH.times(D::TIME, -1);
    let force = speed.times(D::MASS, 1).times(D::TIME, -1);
    Some(match symbol {
        "1" => (1.0, D::NONE),
        "%" => (Ratio::new::<ratio::percent>(1.0).value, D::NONE),
        "m" | "metre" | "metres" | "meter" | "meters" => (1.0, D::LENGTH),
        "um" | "µm" | "μm" => (Length::new::<length::micrometer>(1.0).value, D::LENGTH),
        "mm" => (Length::new::<length::millimeter>(1.0).value, D::LENGTH),
        "cm" => (Length::new::<length::centimeter>(1.0).value, D::LENGTH),
        "km" => (Length::new::<length::kilometer>(1.0).value, D::LENGTH),
        "in" | "inch" | "inches" => (Length::new::<length::inch>(1.0).value, D::LENGTH),
        "ft" | "foot" | "feet" => (Length::new::<length::foot>(1.0).value, D::LENGTH),
        "yd" | "yard" | "yards" => (Length::new::<length::yard>(1.0).value, D::LENGTH),
        "mi" | "mile" | "miles" => (Length::new::<length::mile>(1.0).value, D::LENGTH),
        "L" | "l" => (Volume::new::<volume::liter>(1.0).value, D::NONE.times(D::LENGTH, 3)),
        "kg" => (1.0, D::MASS),
        "g" | "gram" | "grams" => (Mass::new::<mass::gram>(1.0).value, D::MASS),
        "mg" => (Mass::new::<mass::milligram>(1.0).value, D::MASS),
        "oz" => (437.5 * grain(), D::MASS),
        "lb" | "lbs" => (7000.0 * grain(), D::MASS),
        "s" | "sec" | "second" | "seconds" => (1.0, D::TIME),
        "ms" => (Time::new::<time::millisecond>(1.0).value, D::TIME),
        "min" | "minute" | "minutes" => (Time::new::<time::minute>(1.0).value, D::TIME),
        "h" | "hour" | "hours" => (Time::new::<time::hour>(1.0).value, D::TIME),
        "rad" | "radian" | "radians" => (1.0, D::ANGLE),
        "mrad" => (1e-3, D::ANGLE),
        "deg" | "°" | "degree" | "degrees" => (Angle::new::<angle::degree>(1.0).value, D::ANGLE),
        "rev" => (Angle::new::<angle::revolution>(1.0).value, D::ANGLE),
        "rpm" => {
            let turn = Angle::new::<angle::revolution>(1.0).value;
            (turn / 60.0, D::ANGLE.times(D::TIME, -1))
        }
        "mph" => (Velocity::new::<velocity::mile_per_hour>(1.0).value, speed),
        "kph" | "kmh" => (Velocity::new::<velocity::kilometer_per_hour>(1.0).value, speed),
        "kn" | "knot" | "knots" => (Velocity::new::<velocity::knot>(1.0).value, speed),
        "N" => (Force::new::<force::newton>(1.0).value, force),
        "Pa" => (Pressure::new::<pressure::pascal>(1.0).value, force.times(D::LENGTH, -2)),
        "P" => (0.1, D::MASS.times(D::LENGTH, -1).times(D::TIME, -1)),
        "cP" => (1e-3, D::MASS.times(D::LENGTH, -1).times(D::TIME, -1)),
        _ => return None,
    })
}
