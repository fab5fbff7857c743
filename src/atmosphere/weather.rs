use crate::number::{Numbers, inlined};
use crate::parameters::Air;

/// 0 °C, K.
const ICE: f64 = 273.15;

/// K: the temperature where other weather is given and it is not, that of TrackMan's normalised air
/// (25 °C).
const USUAL: f64 = ICE + 25.0;

/// Density and viscosity of the air (docs/model.md, eqs. 12a–12d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AirState<T> {
    /// ρ, kg/m³.
    pub density: T,
    /// μ, Pa s.
    pub viscosity: T,
}

impl<T: Numbers> AirState<T> {
    /// Density and viscosity as given or, where the weather is given, as they follow from it.
    ///
    /// ```
    /// use longdrive::{Setup, atmosphere::AirState};
    /// let mut setup = Setup::default();
    /// assert_eq!(AirState::of(&setup.air).density, 1.184);
    /// setup.set_all([("air.temperature", "10 degC"), ("air.altitude", "1609 m"), ("air.humidity", "40 %")]).unwrap();
    /// assert!((AirState::of(&setup.air).density - 1.0246).abs() < 1e-4);
    /// ```
    #[inline(always)]
    pub fn of(air: &Air<T>) -> Self {
        if !air.has_weather() {
            return Self {
                density: air.density,
                viscosity: air.viscosity,
            };
        }
        T::outlined(inlined!(|| Self::of_weather(air)))
    }

    #[inline(always)]
    fn of_weather(air: &Air<T>) -> Self {
        let temperature = match air.temperature {
            Some(temperature) => temperature,
            None => T::constant(USUAL),
        };
        let pressure = match (air.pressure, air.altitude) {
            (Some(pressure), _) => pressure,
            (None, Some(altitude)) => standard_pressure(altitude),
            (None, None) => T::constant(SEA_LEVEL),
        };
        let vapour = match air.humidity {
            Some(humidity) => humidity * saturation(temperature, pressure),
            None => T::zero(),
        };
        Self {
            density: density(temperature, pressure, vapour),
            viscosity: viscosity(temperature),
        }
    }
}

/// The pressure of the standard atmosphere at sea level, Pa.
const SEA_LEVEL: f64 = 101_325.0;

/// The pressure at an altitude in the standard atmosphere, whose temperature falls by L for each
/// metre (ISO 2533:1975).
#[inline(always)]
fn standard_pressure<T: Numbers>(altitude: T) -> T {
    /// K, K/m, m/s², J/(kg K).
    const GROUND: f64 = 288.15;
    const LAPSE: f64 = 0.0065;
    const GRAVITY: f64 = 9.80665;
    const GAS: f64 = 287.05287;
    (altitude * (-LAPSE / GROUND) + 1.0).powf(GRAVITY / (GAS * LAPSE)) * SEA_LEVEL
}

/// The mole fraction of water vapour in saturated air (CIPM-2007, eq. A1): f p_sv/p.
#[inline(always)]
fn saturation<T: Numbers>(temperature: T, pressure: T) -> T {
    let celsius = temperature - ICE;
    let exponent = temperature * (temperature * 1.237_884_7e-5 - 1.912_131_6e-2) + 33.937_110_47
        - temperature.recip() * 6.343_164_5e3;
    let enhancement = pressure * 3.14e-8 + celsius * celsius * 5.6e-7 + 1.000_62;
    enhancement * exponent.exp() / pressure
}

/// The density of moist air with 400 ppm of carbon dioxide and this mole fraction of water vapour
/// (CIPM-2007, eqs. 1 and A1.4).
#[inline(always)]
fn density<T: Numbers>(temperature: T, pressure: T, vapour: T) -> T {
    let celsius = temperature - ICE;
    let ratio = pressure / temperature;
    let dry = celsius * (celsius * 1.1043e-10 - 2.9331e-8) + 1.581_23e-6;
    let mixed = celsius * -2.051e-8 + 5.707e-6;
    let wet = celsius * -2.376e-6 + 1.9898e-4;
    let square = vapour * vapour;
    let second = square * -0.765e-8 + 1.83e-11;
    let compressibility =
        ratio * ratio * second - ratio * (dry + mixed * vapour + wet * square) + 1.0;
    ratio / compressibility * (vapour * -0.3780 + 1.0) * 3.483_740e-3
}

/// Sutherland's formula with the constants of the U.S. Standard Atmosphere 1976.
#[inline(always)]
fn viscosity<T: Numbers>(temperature: T) -> T {
    temperature * temperature.sqrt() * 1.458e-6 / (temperature + 110.4)
}
