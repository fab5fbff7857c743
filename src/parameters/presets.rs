use super::table::{LAW, Setup};
use crate::error::{Error, Result};
use crate::lock::lock;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// A named setup: its differences from the defaults of the parameter table, each number with its
/// source.
#[derive(Debug)]
pub struct Preset {
    /// Name on the command line.
    pub name: &'static str,
    /// Description, a sentence.
    pub about: &'static str,
    /// Differences from the defaults.
    pub entries: &'static [PresetEntry],
}

/// One number of a preset.
#[derive(Debug)]
pub struct PresetEntry {
    /// Name of the parameter, or of a choice such as `aero.law`.
    pub name: &'static str,
    /// Value, with its unit.
    pub value: &'static str,
    /// Source of the value.
    pub source: &'static str,
}

/// An entry of a preset or of a turf.
pub(super) const fn entry(
    name: &'static str,
    value: &'static str,
    source: &'static str,
) -> PresetEntry {
    PresetEntry {
        name,
        value,
        source,
    }
}

const WINFIELD_TAN: &str = "Winfield & Tan (1994)";
const REPORT: &str = "MAE 494 report, listing";
const NOT_IN_REPORT: &str = "MAE 494 report: not part of the model";
const PGA: &str = "TrackMan, PGA TOUR averages 2023, driver";
const LPGA: &str = "TrackMan, LPGA Tour averages 2023, driver";
const AMATEUR: &str = "TrackMan (2014), Performance of the Average Male Amateur Golfer, as others \
                       cite it (docs/sources.md)";
const LOFT_SOLD: &str =
    "chosen to agree with the launch angle; drivers are sold with 9 to 10.5 deg";
const BEND: &str = "assumed: within 2 to 5 deg, docs/sources.md; the loft was chosen with it";
const GROWTH: &str = "assumed: the load on the shaft grows with the square of the head speed";

/// The preset of a command without a setup, and of a setup file that names no preset.
pub const DEFAULT_PRESET: &str = "tour-average";

/// The presets; `modern-driver` has the defaults of the parameter table.
pub static PRESETS: &[Preset] = &[
    Preset {
        name: "modern-driver",
        about: "A 460 cc driver of the 2020s at 110 mph in 25 °C sea-level air, with drag and lift \
                fitted to launch monitors' predictions",
        entries: &[],
    },
    Preset {
        name: "tour-average",
        about: "The average drive of the PGA TOUR 2023 in 25 °C sea-level air: the published \
                delivery, with a head and a shaft chosen so that ball, \
                apex and landing agree with the published averages",
        entries: &[
            entry("swing.speed", "115 mph", PGA),
            entry("swing.attack_angle", "-0.9 deg", PGA),
            entry("swing.shaft_bend", "2.5 deg", BEND),
            entry("swing.shaft_growth", "2", GROWTH),
            entry(
                "strike.high",
                "6 mm",
                "chosen to agree with the spin; the face centre of the measured driver lies 4.3 mm \
                 above its sweet spot",
            ),
            entry(
                "club.loft",
                "8.8 deg",
                "chosen to agree with the launch angle; 9 to 10.5 deg are sold",
            ),
            entry(
                "impact.restitution",
                "0.859",
                "chosen to agree with the ball speed; the USGA limit is 0.83, docs/sources.md",
            ),
        ],
    },
    Preset {
        name: "lpga-average",
        about: "The average drive of the LPGA Tour 2023 in 25 °C sea-level air: the published \
                delivery, with head, shaft and drag chosen so that ball, \
                apex and landing agree with the published averages",
        entries: &[
            entry("swing.speed", "96 mph", LPGA),
            entry("swing.attack_angle", "2.8 deg", LPGA),
            entry("swing.shaft_bend", "2.5 deg", BEND),
            entry("swing.shaft_growth", "2", GROWTH),
            entry("club.loft", "9.5 deg", LOFT_SOLD),
            entry(
                "impact.restitution",
                "0.852",
                "chosen to agree with the ball speed; the USGA limit is 0.83, docs/sources.md",
            ),
            entry(
                "impact.tangential_restitution",
                "-0.03",
                "chosen: launch angle and spin are then in the ratio of TrackMan's driver chart, \
                 docs/sources.md; 0 is rolling at exit (Winfield & Tan 1994, Penner 2001)",
            ),
            entry(
                "aero.cd0",
                "0.1575",
                "the law's 0.14972, plus 0.0078 chosen to agree with the carry: the mean carry of \
                 drives is shorter than the carry of their mean launch, docs/sources.md",
            ),
        ],
    },
    Preset {
        name: "amateur-average",
        about: "An average male amateur's drive in 25 °C sea-level air, with head, shaft and \
                strike chosen to agree with ball speed, launch angle and \
                spin; its carry is 1 % longer than the published 204 yd",
        entries: &[
            entry("swing.speed", "93.4 mph", AMATEUR),
            entry("swing.attack_angle", "-1.6 deg", AMATEUR),
            entry(
                "swing.shaft_lean",
                "-4.8 deg",
                "chosen to agree with the launch angle, 12.6 deg: hands behind the ball add loft",
            ),
            entry("swing.shaft_bend", "2.5 deg", BEND),
            entry("swing.shaft_growth", "2", GROWTH),
            entry(
                "strike.high",
                "-2.6 mm",
                "chosen to agree with the spin, 3275 rpm: amateurs are assumed to strike low",
            ),
            entry("club.loft", "10.5 deg", "assumed: the loft most sold"),
            entry(
                "impact.restitution",
                "0.818",
                "chosen to agree with the ball speed, 132.6 mph: it includes the loss of \
                 strikes off the centre",
            ),
        ],
    },
    Preset {
        name: "winfield-tan",
        about: "Winfield & Tan (1994), 203 g head at 110 mph. Their drag and lift curves (Aoyama \
                1990) are not printed: \
                the law winfield-tan is recovered from their tables",
        entries: &[
            entry(
                "swing.speed",
                "110 mph",
                "Winfield & Tan (1994), the speed they optimize at (their single shot: 103 mph)",
            ),
            entry(
                "swing.attack_angle",
                "0 deg",
                "Winfield & Tan (1994), their single shot",
            ),
            entry("club.mass", "203 g", WINFIELD_TAN),
            entry(
                "club.loft",
                "10 deg",
                "Winfield & Tan (1994), their single shot",
            ),
            entry(
                "club.inertia.xx",
                "2.06e-4 kg m^2",
                "MAE 494 report, rounded; without effect on a straight shot",
            ),
            entry(
                "club.inertia.yy",
                "3.77e-4 kg m^2",
                "MAE 494 report; with the depth it gives d²/I_yy = 3.02 per kg, which the printed \
                 spin implies",
            ),
            entry(
                "club.inertia.zz",
                "2.74e-4 kg m^2",
                "MAE 494 report, rounded; without effect on a straight shot",
            ),
            entry(
                "club.inertia.xz",
                "0 kg m^2",
                "straight shots of a symmetric head",
            ),
            entry(
                "club.cg_depth",
                "33.7 mm",
                "implied by the printed spin, see club.inertia.yy",
            ),
            entry(
                "club.bulge_radius",
                "inf",
                "without effect on a strike on the sweet spot, the only one in the paper's results",
            ),
            entry(
                "club.roll_radius",
                "inf",
                "without effect on a strike on the sweet spot, the only one in the paper's results",
            ),
            entry(
                "ball.mass",
                "46.1 g",
                "implied by the printed speeds: 203 g (103 − 71.39)/139.16",
            ),
            entry("ball.radius", "0.84 in", WINFIELD_TAN),
            entry("impact.restitution", "0.7", WINFIELD_TAN),
            entry(
                "impact.tangential_restitution",
                "0",
                "Winfield & Tan (1994) eqs. 19–20: no slip at exit",
            ),
            entry(
                "impact.gear_scale",
                "none",
                "Winfield & Tan (1994): rigid bodies",
            ),
            entry(
                "air.density",
                "1.2 kg/m^3",
                "not stated; 20 °C at sea level",
            ),
            entry("air.viscosity", "1.81e-5 Pa s", "not stated; 20 °C"),
            entry(
                "aero.spin_decay",
                "0.045 1/s",
                "within what the paper's tables allow, docs/validation.md; the printed 0.6–0.7 has \
                 no unit",
            ),
            entry(
                "ground.restitution",
                "none",
                "Winfield & Tan (1994): the ball embeds where it lands",
            ),
            entry(
                "flight.step",
                "5 ms",
                "not stated; the error is below 1e-9 m",
            ),
            entry(
                LAW,
                "winfield-tan",
                "recovered from the paper's tables, docs/validation.md: distances within 0.33 yd, \
                 optimum angles within 0.14°",
            ),
        ],
    },
    Preset {
        name: "mae494",
        about: "The MAE 494 report's constants in Winfield & Tan's equations, with the report's \
                law of drag and lift",
        entries: &[
            entry("swing.speed", "44.7 m/s", REPORT),
            entry(
                "swing.attack_angle",
                "0 deg",
                "the middle of the report's ranges",
            ),
            entry("club.mass", "230 g", REPORT),
            entry("club.loft", "10 deg", "the middle of the report's ranges"),
            entry("club.inertia.xx", "2.057e-4 kg m^2", REPORT),
            entry("club.inertia.yy", "3.77e-4 kg m^2", REPORT),
            entry("club.inertia.zz", "2.738e-4 kg m^2", REPORT),
            entry("club.inertia.xz", "0 kg m^2", REPORT),
            entry("club.cg_depth", "37 mm", REPORT),
            entry("club.bulge_radius", "inf", NOT_IN_REPORT),
            entry("club.roll_radius", "inf", NOT_IN_REPORT),
            entry("ball.mass", "49 g", REPORT),
            entry(
                "ball.radius",
                "21.336 mm",
                "MAE 494 report, flight model; the report's impact model rounds the radius to 21 mm",
            ),
            entry("ball.inertia", "5.85e-6 kg m^2", REPORT),
            entry("impact.restitution", "0.7", REPORT),
            entry("impact.tangential_restitution", "0", NOT_IN_REPORT),
            entry("impact.gear_scale", "none", NOT_IN_REPORT),
            entry("air.density", "1.225 kg/m^3", REPORT),
            entry("air.viscosity", "1.81e-5 Pa s", NOT_IN_REPORT),
            entry("gravity", "9.81 m/s^2", REPORT),
            entry(
                "aero.spin_decay",
                "0.7 1/s",
                "MAE 494 report, from Winfield & Tan's 0.6–0.7",
            ),
            entry(
                "ground.restitution",
                "none",
                "MAE 494 report: the distance is the carry",
            ),
            entry("flight.step", "0.01 s", "MAE 494 report, listing: h = 0.01"),
            entry(
                LAW,
                "robinson",
                "MAE 494 report, listing: 0.3, 2.58e-4, 0.319, 2.48e-3",
            ),
        ],
    },
];

impl Preset {
    /// The preset of this name; `None` if no preset has it.
    pub fn named(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// The preset of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no preset has this name.
    pub fn known(name: &str) -> Result<&'static Self> {
        Self::named(name).ok_or_else(|| {
            let names = PRESETS.iter().map(|preset| preset.name);
            let advice = format!("the presets are {}", Self::names());
            Error::unknown("preset", name, names, advice)
        })
    }

    /// Names of all presets, separated by commas.
    pub fn names() -> String {
        PRESETS
            .iter()
            .map(|preset| preset.name)
            .collect::<Vec<_>>()
            .join(", ")
    }
}

impl Setup<f64> {
    /// The preset of this name: `modern-driver`, `tour-average`, `lpga-average`, `amateur-average`,
    /// `winfield-tan` or `mae494`.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no preset has this name.
    pub fn preset(name: &str) -> Result<Self> {
        // the texts are parsed once, because that takes longer than a drive
        static SETUPS: Mutex<BTreeMap<&str, Setup<f64>>> = Mutex::new(BTreeMap::new());
        let preset = Preset::known(name)?;
        let mut setups = lock(&SETUPS);
        if let Some(setup) = setups.get(name) {
            return Ok(*setup);
        }
        let mut setup = Self::modern_driver();
        let entries = preset.entries.iter();
        setup.set_all(entries.map(|entry| (entry.name, entry.value)))?;
        setups.insert(preset.name, setup);
        Ok(setup)
    }
}
