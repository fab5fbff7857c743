use crate::number::{Numbers, inlined};
use crate::parameters::{Air, DEFAULT_TEMPERATURE, LAPSE_RATE, SEA_LEVEL_TEMPERATURE};

/// 0 °C, K.
const FREEZING: f64 = 273.15;

/// Density and viscosity of the air (docs/model.md, eqs. 12a–12d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AirState<T> {
    /// Density ρ, kg/m³.
    pub density: T,
    /// Dynamic viscosity μ, Pa s.
    pub viscosity: T,
}

impl<T: Numbers> AirState<T> {
    /// Reynolds number divided by airspeed, ρ 2R/μ, s/m, of a ball with the radius R, m.
    ///
    /// ```
    /// use longdrive::atmosphere::AirState;
    /// let air = AirState { density: 1.2, viscosity: 1.8e-5 };
    /// assert!((air.reynolds_per_speed(0.021) - 2800.0_f64).abs() < 1e-9);
    /// ```
    #[inline(always)]
    pub fn reynolds_per_speed(&self, radius: T) -> T {
        self.density * radius * 2.0 / self.viscosity
    }

    /// Density and viscosity as given, or computed from the weather if the weather is given.
    ///
    /// ```
    /// use longdrive::{Setup, atmosphere::AirState};
    /// let mut setup = Setup::modern_driver();
    /// assert_eq!(AirState::of(&setup.air).density, 1.184);
    /// let air = [("air.temperature", "10 degC"), ("air.altitude", "1609 m"), ("air.humidity", "40 %")];
    /// setup.set_all(air).unwrap();
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
        T::not_inlined(inlined!(|| Self::of_weather(air)))
    }

    #[inline(always)]
    fn of_weather(air: &Air<T>) -> Self {
        let temperature = match air.temperature {
            Some(temperature) => temperature,
            None => T::constant(DEFAULT_TEMPERATURE),
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

/// Pressure of the standard atmosphere at sea level, Pa.
const SEA_LEVEL: f64 = 101_325.0;

/// Pressure at an altitude in the standard atmosphere (ISO 2533:1975; docs/model.md, eq. 12c).
#[inline(always)]
fn standard_pressure<T: Numbers>(altitude: T) -> T {
    /// Standard gravity, m/s².
    const GRAVITY: f64 = 9.80665;
    /// Gas constant of air, J/(kg K).
    const GAS_CONSTANT: f64 = 287.05287;
    let temperature_ratio = altitude * (-LAPSE_RATE / SEA_LEVEL_TEMPERATURE) + 1.0;
    temperature_ratio.powf(GRAVITY / (GAS_CONSTANT * LAPSE_RATE)) * SEA_LEVEL
}

/// Mole fraction of water vapour in saturated air, f p_sv/p (CIPM-2007, eq. A1; docs/model.md,
/// eq. 12a).
#[inline(always)]
fn saturation<T: Numbers>(temperature: T, pressure: T) -> T {
    let celsius = temperature - FREEZING;
    let exponent = temperature * (temperature * 1.237_884_7e-5 - 1.912_131_6e-2) + 33.937_110_47
        - temperature.recip() * 6.343_164_5e3;
    let enhancement = pressure * 3.14e-8 + celsius * celsius * 5.6e-7 + 1.000_62;
    enhancement * exponent.exp() / pressure
}

/// Density of moist air with 400 ppm of carbon dioxide and the mole fraction `vapour` of water
/// (CIPM-2007, eqs. 1 and A1.4; docs/model.md, eqs. 12a, 12b).
#[inline(always)]
fn density<T: Numbers>(temperature: T, pressure: T, vapour: T) -> T {
    let celsius = temperature - FREEZING;
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

/// Sutherland's formula with the constants of the U.S. Standard Atmosphere 1976 (docs/model.md,
/// eq. 12d).
#[inline(always)]
fn viscosity<T: Numbers>(temperature: T) -> T {
    temperature * temperature.sqrt() * 1.458e-6 / (temperature + 110.4)
}
