use crate::atmosphere::in_effect;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Wind};
use crate::repeated::first_repeated;
use crate::units::{Quantity, typed};

/// A standard uncertainty of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigma {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Standard deviation, SI.
    pub value: f64,
    /// Source of the uncertainty; `None` if the user gave it.
    pub source: Option<&'static str>,
}

impl Sigma {
    /// Parses `NAME=AMOUNT`, for example `swing.speed=1mph`, or `air.density=0.5%`. A percentage is
    /// relative to the parameter's value, also for a dimensionless parameter.
    ///
    /// ```
    /// use longdrive::{Setup, study::Sigma};
    /// let setup = Setup::modern_driver();
    /// assert_eq!(Sigma::read(&setup, "swing.speed=1 m/s").unwrap().value, 1.0);
    /// assert_eq!(Sigma::read(&setup, "swing.speed=10%").unwrap().value, 0.1 * setup.swing.speed);
    /// assert!(Sigma::read(&setup, "swing.speed=-1 m/s").is_err());
    /// let cl_max = Sigma::read(&setup, "aero.cl_max=10%").unwrap().value;
    /// assert_eq!(cl_max, 0.1 * setup.value(setup.parameter("aero.cl_max").unwrap()).unwrap());
    /// // a percentage of 0 is refused
    /// let error = Sigma::read(&setup, "swing.path=1%").unwrap_err();
    /// assert!(error.to_string().contains("swing.path is 0; write an amount, for example 1 deg"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Unreadable`] for an amount that is not positive, and for a percentage of a value that
    /// is 0, unset, or a temperature; the errors of [`Setup::variable`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let (name, amount) = name_and_amount(text)?;
        let parameter = setup.variable(name)?;
        let unreadable = |source| unreadable(text, source);
        let value =
            amount_of(setup, parameter, amount, AmountKind::Deviation).map_err(unreadable)?;
        if value > 0.0 && value.is_finite() {
            return Ok(Self {
                parameter,
                value,
                source: None,
            });
        }
        let (name, unit) = (parameter.name, parameter.unit);
        let given = parameter.show(Some(value));
        let example = format!("{name}=1 {unit}");
        let reason = format!(
            "the standard uncertainty of {name} would be {given}, but it must be above 0 and \
             finite; write for example {}",
            example.trim_end()
        );
        Err(unreadable(reason.into()))
    }

    /// The parameter that the text `NAME=AMOUNT` names. The amount is not read.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a text without `=`; the errors of [`Setup::variable`].
    pub fn named(setup: &Setup<f64>, text: &str) -> Result<&'static Parameter> {
        let (name, _) = name_and_amount(text)?;
        setup.variable(name)
    }

    /// Checks that the setup has the parameter and that the value is valid. Only uncertainties
    /// parsed from text were checked before.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a value that is not positive and finite; the errors of
    /// [`Setup::variable`]; [`Error::OtherLaw`] for a coefficient of another law.
    pub(super) fn check(&self, setup: &Setup<f64>) -> Result<()> {
        let parameter = self.parameter;
        setup.check_variable(parameter)?;
        if self.value > 0.0 && self.value.is_finite() {
            return Ok(());
        }
        let source = format!(
            "it is {}, but must be above 0 and finite",
            parameter.show(Some(self.value))
        );
        Err(Error::unreadable(
            format!("the standard uncertainty of {parameter}"),
            source,
        ))
    }
}

/// The name and the amount of a text `NAME=AMOUNT`.
fn name_and_amount(text: &str) -> Result<(&str, &str)> {
    if let Some((name, amount)) = text.split_once('=') {
        return Ok((name.trim(), amount));
    }
    let source = "write NAME=AMOUNT, for example swing.speed=1mph or air.density=0.5%";
    Err(unreadable(text, source.into()))
}

/// The error for a text `NAME=AMOUNT`.
fn unreadable(text: &str, source: Box<dyn std::error::Error + Send + Sync>) -> Error {
    let name = format!("the standard uncertainty {}", text.trim());
    Error::Unreadable { name, source }
}

/// Refuses two uncertainties of a parameter.
///
/// # Errors
/// [`Error::Unreadable`] for a parameter that is given twice.
pub fn refuse_given_twice(parameters: impl IntoIterator<Item = &'static Parameter>) -> Result<()> {
    let parameters: Vec<_> = parameters.into_iter().collect();
    let Some([_, again]) = first_repeated(&parameters, |a, b| a == b) else {
        return Ok(());
    };
    let name = format!("the uncertainty of {}", parameters[again].name);
    Err(Error::unreadable(name, "it is given twice; keep one"))
}

/// Purpose of an amount of a parameter.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum AmountKind {
    /// A value, with the zero of its unit.
    Value,
    /// A change of the value.
    Change,
    /// A standard deviation. A percentage is relative to the magnitude of the value.
    Deviation,
}

/// Parses an amount of a parameter, in SI. A percentage is relative to the parameter's value, also
/// for a dimensionless parameter.
///
/// # Errors
/// For a number or unit that cannot be read, and for a percentage of a value that is 0 or unset, or
/// whose unit has an offset (°C): 5 % of 10 °C could mean 0.5 °C or 14 K. For a percentage as the
/// value of a dimensionless parameter: elsewhere, a humidity of 40 % is 0.4.
pub(super) fn amount_of(
    setup: &Setup<f64>,
    parameter: &Parameter,
    text: &str,
    amount: AmountKind,
) -> std::result::Result<f64, Box<dyn std::error::Error + Send + Sync>> {
    let text = text.trim();
    let percent = text.strip_suffix('%');
    let percent = percent.and_then(|number| number.trim().parse::<f64>().ok());
    let Some(percent) = percent.filter(|percent| !percent.is_nan()) else {
        let read = match amount {
            AmountKind::Value => Quantity::read,
            AmountKind::Change | AmountKind::Deviation => Quantity::read_difference,
        };
        return read(parameter.quantity, text).map_err(Into::into);
    };
    let name = parameter.name;
    let has_offset = parameter.quantity.number_in(0.0, parameter.unit) != 0.0;
    let why = match setup.value(parameter) {
        _ if has_offset => format!("the zero of {} is arbitrary", parameter.unit),
        _ if amount == AmountKind::Value && parameter.quantity == Quantity::NUMBER => {
            format!("here {text} could also mean the number {}", percent / 100.0)
        }
        None => format!("{name} is unset"),
        Some(0.0) => format!("{name} is 0"),
        Some(own) => {
            let own = match amount {
                AmountKind::Deviation => own.abs(),
                AmountKind::Value | AmountKind::Change => own,
            };
            return Ok(percent / 100.0 * own);
        }
    };
    let example = typed("1", parameter.unit);
    Err(format!(
        "a percentage is relative to the value, and {why}; write an amount, for example {example}"
    )
    .into())
}

/// A default standard uncertainty.
enum DefaultSigma {
    /// An amount with its unit.
    Of(f64, &'static str),
    /// A fraction of the parameter's value.
    Part(f64),
    /// [`MEAN_WIND`] and the gusts (root of the sum of squares).
    Wind,
}

/// Standard uncertainty of the mean wind, m/s.
const MEAN_WIND: f64 = 1.0;

/// Roughness length, m, that determines the gusts in a setup without `wind.roughness`: open country
/// with low vegetation (EN 1991-1-4, terrain category II).
const OPEN_COUNTRY: f64 = 0.05;

/// Standard uncertainty of the height of the sweet spot on the face, m.
const SWEET_SPOT: f64 = 3e-3;

/// Ratio σ_v/σ_u of the gusts across the wind to the gusts along the wind (Panofsky & Dutton 1984:
/// 1.92/2.39).
const ACROSS: f64 = 0.8;

/// Standard deviations from drive to drive that gusts cause, m/s: of the wind to the right, of the
/// wind downrange, and of the wind speed. Along the wind, the standard deviation is the wind speed
/// times the turbulence intensity, which is 1/ln(z_ref/z₀) at the reference height.
fn gusts(setup: &Setup<f64>) -> [f64; 3] {
    let wind = &setup.wind;
    let Wind {
        right, downrange, ..
    } = in_effect(setup).wind;
    let heights = wind.reference_height / wind.roughness.unwrap_or(OPEN_COUNTRY);
    // near the roughness length the wind profile is not valid: limit the intensity to 1
    let intensity = heights.max(std::f64::consts::E).ln().recip();
    let component = |own: f64, other: f64| intensity * own.hypot(ACROSS * other);
    [
        component(right, downrange),
        component(downrange, right),
        intensity * right.hypot(downrange),
    ]
}

const CLUB_SPEED: &str = "assumed: the club speed is known within 0.5 mph; `delivery` takes 1.5 \
                          mph for a launch monitor";
const CLUB_ANGLE: &str = "assumed: as for the ball's launch angle, 0.3 deg; `delivery` takes 1 deg \
                          for a launch monitor";
const LOFT: &str = "assumed: as for the ball's launch angle, 0.3 deg";
const BALL: &str = "assumed: the uncertainty of launch monitors for the ball, as in `calibrate` \
                    for columns without sigma";
const STRIKE: &str = "assumed: a mark on the face, read to a millimetre";
const STRIKE_WITH_SWEET_SPOT: &str = "assumed: a mark on the face is read to a millimetre, and \
                                      the height of the sweet spot is known within 3 mm \
                                      (docs/sources.md)";
const SPOT: &str = "docs/sources.md: the height of the sweet spot is known within 3 mm";
const LAW_DRAG: &str = "docs/sources.md: credible laws differ by 0.015 in C_D";
const LAW_LIFT: &str = "docs/sources.md: credible laws differ by 0.02 in C_L, or 10 %";
const AIR: &str = "assumed: temperature within 1.5 °C";
const PRESSURE: &str = "assumed: pressure within 3 hPa";
const ALTITUDE: &str = "assumed: pressure within 3 hPa of the standard pressure at the altitude";
const HUMIDITY: &str = "assumed: humidity within 10 %";
const BEARING: &str = "assumed: wind direction within 10 deg";
const WIND: &str =
    "assumed: mean wind within 1 m/s, and gusts with σ_u/u = 1/ln(z_ref/z₀) (docs/sources.md)";
const TURF: &str = "assumed: fairways differ, and no measurement has calibrated these values; the \
                    total of a tour drive is then known within about 10 yd";

/// Default uncertainties, for a single drive that was measured on a driving range in calm air.
const DEFAULTS: &[(&str, DefaultSigma, &str)] = &[
    ("swing.speed", DefaultSigma::Of(0.5, "mph"), CLUB_SPEED),
    (
        "swing.attack_angle",
        DefaultSigma::Of(0.3, "deg"),
        CLUB_ANGLE,
    ),
    ("swing.path", DefaultSigma::Of(0.3, "deg"), CLUB_ANGLE),
    ("swing.face_angle", DefaultSigma::Of(0.3, "deg"), CLUB_ANGLE),
    ("club.loft", DefaultSigma::Of(0.3, "deg"), LOFT),
    (
        "club.cg_high",
        DefaultSigma::Of(1e3 * SWEET_SPOT, "mm"),
        SPOT,
    ),
    ("strike.high", DefaultSigma::Of(1.0, "mm"), STRIKE),
    ("strike.toe", DefaultSigma::Of(1.0, "mm"), STRIKE),
    ("launch.ball_speed", DefaultSigma::Of(1.0, "mph"), BALL),
    ("launch.launch_angle", DefaultSigma::Of(0.3, "deg"), BALL),
    (
        "launch.launch_direction",
        DefaultSigma::Of(0.3, "deg"),
        BALL,
    ),
    ("launch.backspin", DefaultSigma::Of(100.0, "rpm"), BALL),
    ("launch.sidespin", DefaultSigma::Of(100.0, "rpm"), BALL),
    ("launch.spin", DefaultSigma::Of(100.0, "rpm"), BALL),
    ("launch.spin_axis", DefaultSigma::Of(2.0, "deg"), BALL),
    (
        "impact.tangential_restitution",
        DefaultSigma::Of(0.06, ""),
        "docs/sources.md: −0.1 ± 0.06",
    ),
    (
        "impact.gear_scale",
        DefaultSigma::Of(0.2, ""),
        "docs/sources.md: 0.75 ± 0.2",
    ),
    ("air.density", DefaultSigma::Part(0.005), AIR),
    ("air.temperature", DefaultSigma::Of(1.5, "K"), AIR),
    ("air.pressure", DefaultSigma::Of(3.0, "hPa"), PRESSURE),
    ("air.altitude", DefaultSigma::Of(25.0, "m"), ALTITUDE),
    ("air.humidity", DefaultSigma::Of(0.1, ""), HUMIDITY),
    ("wind.right", DefaultSigma::Wind, WIND),
    ("wind.downrange", DefaultSigma::Wind, WIND),
    ("wind.speed", DefaultSigma::Wind, WIND),
    ("wind.from", DefaultSigma::Of(10.0, "deg"), BEARING),
    ("ground.restitution", DefaultSigma::Of(0.1, ""), TURF),
    ("ground.compliance", DefaultSigma::Of(5.0, "deg"), TURF),
    ("ground.rolling", DefaultSigma::Part(0.25), TURF),
    ("aero.cd", DefaultSigma::Of(0.015, ""), LAW_DRAG),
    ("aero.cd0", DefaultSigma::Of(0.015, ""), LAW_DRAG),
    ("aero.cd_factor", DefaultSigma::Part(0.06), LAW_DRAG),
    ("aero.cl_max", DefaultSigma::Part(0.1), LAW_LIFT),
    ("aero.cl_factor", DefaultSigma::Part(0.1), LAW_LIFT),
    ("aero.cl_slope", DefaultSigma::Part(0.1), LAW_LIFT),
];

/// The given uncertainties, then the defaults of other parameters. A parameter that affects only
/// the run has a default only if an outcome in `of` needs the run.
///
/// # Errors
/// [`Error::Unreadable`] for a parameter that is given twice.
pub fn with_defaults(setup: &Setup<f64>, given: &[Sigma], of: &[Outcome]) -> Result<Vec<Sigma>> {
    refuse_given_twice(given.iter().map(|sigma| sigma.parameter))?;
    let mut all = given.to_vec();
    let runs = of.iter().any(|of| of.needs_run());
    for (name, amount, source) in DEFAULTS {
        let Ok(parameter) = setup.variable(name) else {
            continue;
        };
        let has_no_effect = parameter.affects_only_run() && !runs;
        if has_no_effect || given.iter().any(|sigma| sigma.parameter == parameter) {
            continue;
        }
        let value = match amount {
            DefaultSigma::Of(number, unit) => {
                number * parameter.quantity.size_of(unit).unwrap_or(1.0)
            }
            DefaultSigma::Part(part) => part * setup.value(parameter).unwrap_or_default().abs(),
            DefaultSigma::Wind => {
                let [right, downrange, speed] = gusts(setup);
                MEAN_WIND.hypot(match *name {
                    "wind.right" => right,
                    "wind.downrange" => downrange,
                    _ => speed,
                })
            }
        };
        let (value, source) = match (*name, setup.club.cg_high) {
            ("strike.high", None) => (value.hypot(SWEET_SPOT), STRIKE_WITH_SWEET_SPOT),
            _ => (value, *source),
        };
        if value > 0.0 {
            all.push(Sigma {
                parameter,
                value,
                source: Some(source),
            });
        }
    }
    Ok(all)
}
