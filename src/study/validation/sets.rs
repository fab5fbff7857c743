use super::compared::Compared;
use serde::Serialize;

/// Method by which the drives of a set are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Computation {
    /// From the published launch.
    Launch,
    /// From the published launch, in each case's air. The carry is relative to the first case.
    Altitude,
    /// From the launch of the first case, in each case's air. The carry is relative to the first
    /// case.
    AltitudeAlone,
    /// From an impact of a preset's club, with the face open by the face-to-path angle.
    FaceToPath,
    /// From an impact of a preset's club, at the loft of longest carry.
    Optimum,
}

impl Computation {
    /// Compared quantities, the most important first.
    pub fn compared(self) -> &'static [Compared] {
        match self {
            Self::Launch => &[Compared::Carry, Compared::Apex, Compared::Descent],
            Self::Altitude | Self::AltitudeAlone => &[Compared::Gain],
            Self::FaceToPath => &[Compared::Curve],
            Self::Optimum => &[Compared::Carry, Compared::LaunchAngle, Compared::Spin],
        }
    }
}

/// Published drives of one kind.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Set {
    /// The name of the set.
    pub name: &'static str,
    /// The title of the set.
    pub title: &'static str,
    /// A description of the set.
    // measurement and computation
    pub about: &'static str,
    /// The air of the drives.
    pub air: &'static str,
    /// Limits of the data, and effects that no law can reproduce.
    pub misses: &'static str,
    /// Method of computation.
    #[serde(skip)]
    pub computation: Computation,
    /// True if the cases are averages of many drives.
    #[serde(skip)]
    pub is_averaged: bool,
    /// True if the published values were measured, and the drives are computed from their launch.
    /// False for results of models, gains and optima.
    #[serde(skip)]
    pub is_measured: bool,
    /// Preset of the club, if all cases share it.
    #[serde(skip)]
    pub preset: Option<&'static str>,
    /// Name of the set's rows in the data file.
    #[serde(skip)]
    pub(super) data_name: &'static str,
}

const NOT_STATED: &str = "not stated";
const AVERAGES: &str = "Means over players, ranges and events, rounded to a yard. The drive of the \
                        average launch is flown: an average of scattered drives \
                        carries some 5 yd less (docs/sources.md).";
const OTHER_CLUBS: &str = "No law meets carry and descent together. Those that meet the carry \
                           within 5 yd on average land 2 to 6° flatter than is measured. With \
                           usga-itr \
                       the descent is met within 1° on average, and the ball carries 8 to 13 yd \
                           less; with lyu it lands 1 to 2° flatter, and carries 38 to 53 yd more; \
                           with winfield-tan it \
                       lands 10° steeper, and carries 32 to 49 yd less. Spin ratios of short irons \
                           are beyond what most laws were fitted to.";

const CHART: &str = "Output of a vendor's model of 2010. The chart also states the loft at impact: \
                     with that loft the club of lpga-average gives the chart's spin within 3 % and \
                     its launch \
                     angle within 0.5°, modern-driver spins 14 % less, tour-average 18 to 29 % \
                     less. So the impact, not the flight, explains most of the spin that \
                     tour-average lacks at the optimum. No club meets the chart and the PGA TOUR's \
                     average together: at 115 mph, an attack angle of -0.9° and a launch angle of \
                     10.4° the chart's \
                     ball has 3340 rpm, the average 2545 rpm. With the LPGA Tour's delivery the \
                     chart's ball has 2420 rpm, the LPGA Tour's average 2506 rpm. Near the best \
                     loft the carry changes little, so the launch angle and the spin at this loft \
                     are known less well than the carry.";

/// The sets, the most informative first.
pub static SETS: [Set; 14] = [
    Set {
        name: "pga-driver",
        title: "PGA TOUR averages, driver",
        about: "TrackMan's averages of 2023, 2019 and 2010, flown from their launch.",
        air: NOT_STATED,
        misses: AVERAGES,
        computation: Computation::Launch,
        is_averaged: true,
        is_measured: true,
        preset: None,
        data_name: "pga-driver",
    },
    Set {
        name: "lpga-driver",
        title: "LPGA Tour averages, driver",
        about: "TrackMan's averages of 2023 and 2019, flown from their launch.",
        air: NOT_STATED,
        misses: AVERAGES,
        computation: Computation::Launch,
        is_averaged: true,
        is_measured: true,
        preset: None,
        data_name: "lpga-driver",
    },
    Set {
        name: "pga-radar",
        title: "PGA TOUR radar, five seasons",
        about: "Tracked tee shots, 10 000 to 114 000 a season, flown from the season's average \
                launch.",
        air: "the air at the events; in 2022-23 its density was 0.992 times the density at 25 °C \
              and sea level",
        misses: "Elevation and wind are not taken out. The time of flight is not compared: the \
                 published 6.2 to 6.4 s is 0.4 to 0.8 s less than with any \
                 law that meets the apex, and its definition is not known.",
        computation: Computation::Launch,
        is_averaged: true,
        is_measured: true,
        preset: None,
        data_name: "pga-radar",
    },
    Set {
        name: "pga-clubs",
        title: "PGA TOUR averages, other clubs",
        about: "TrackMan's averages of 2023 and 2019, 3-wood to pitching wedge, flown from their \
                launch.",
        air: NOT_STATED,
        misses: OTHER_CLUBS,
        computation: Computation::Launch,
        is_averaged: false,
        is_measured: true,
        preset: None,
        data_name: "pga-clubs",
    },
    Set {
        name: "lpga-clubs",
        title: "LPGA Tour averages, other clubs",
        about: "TrackMan's averages of 2023 and 2019, 3-wood to pitching wedge, flown from their \
                launch.",
        air: NOT_STATED,
        misses: OTHER_CLUBS,
        computation: Computation::Launch,
        is_averaged: false,
        is_measured: true,
        preset: None,
        data_name: "lpga-clubs",
    },
    Set {
        name: "robots",
        title: "Robots",
        about: "Iron Byron of Winfield & Tan (mean of 20 drives, 200.3 ± 3.6 yd) and four drivers \
                of a robot at 95 mph.",
        air: NOT_STATED,
        misses: "Iron Byron's launch is computed by Winfield & Tan's model, for a ball of 1994. \
                 The robot's four do not agree with each other: 136.8 mph, \
                 11.2°, 2468 rpm carries 220.9 yd, and 137.8 mph, 9.9°, 3182 rpm carries 213.9 yd; \
                 its launch monitor is not named.",
        computation: Computation::Launch,
        is_averaged: false,
        is_measured: true,
        preset: None,
        data_name: "robots",
    },
    Set {
        name: "altitude",
        title: "Gain of carry on high courses",
        about: "Seven events of the PGA TOUR, with the same players there and elsewhere, flown \
                from the launch of each event.",
        air: "stated, as a fraction of the density at 25 °C and sea level",
        misses: "The launch at sea level is assumed to be the season's average. At altitude \
                 players launch up to 3° higher, and with this launch the laws gain more carry \
                 than is measured.",
        computation: Computation::Altitude,
        is_averaged: false,
        is_measured: false,
        preset: None,
        data_name: "altitude",
    },
    Set {
        name: "altitude-alone",
        title: "Gain of carry on high courses, by the air alone",
        about: "The events of altitude, flown from the launch at sea level.",
        air: "stated, as a fraction of the density at 25 °C and sea level",
        misses: "The measured gain includes the effect of the higher launch.",
        computation: Computation::AltitudeAlone,
        is_averaged: false,
        is_measured: false,
        preset: None,
        data_name: "altitude",
    },
    Set {
        name: "face-to-path",
        title: "Curve by face-to-path",
        about: "TrackMan's curve of four centred drives, computed with the clubs of tour-average \
                and lpga-average; the face is open by the face-to-path angle.",
        air: NOT_STATED,
        misses: "Output of a vendor's model.",
        computation: Computation::FaceToPath,
        is_averaged: false,
        is_measured: false,
        preset: None,
        data_name: "face-to-path",
    },
    Set {
        name: "chart-launches",
        title: "TrackMan's driver chart, its launches",
        about: "The 60 launches of TrackMan's fitting chart of 2010, 75 to 120 mph, flown as they \
                are.",
        air: NOT_STATED,
        misses: "Output of a vendor's model.",
        computation: Computation::Launch,
        is_averaged: false,
        is_measured: false,
        preset: None,
        data_name: "chart-launches",
    },
    Set {
        name: "chart-optima",
        title: "TrackMan's driver chart, its optima",
        about: "The 30 rows of longest carry: the loft of longest carry is computed for the club \
                of tour-average (the default) at the row's club speed and attack angle; carry and \
                launch at this loft are compared.",
        air: NOT_STATED,
        misses: CHART,
        computation: Computation::Optimum,
        is_averaged: false,
        is_measured: false,
        preset: Some("tour-average"),
        data_name: "chart-optima",
    },
    Set {
        name: "chart-optima-centred",
        title: "TrackMan's driver chart, its optima with a centred strike",
        about: "The rows of chart-optima with the club of modern-driver, whose strike is on the \
                sweet spot.",
        air: NOT_STATED,
        misses: CHART,
        computation: Computation::Optimum,
        is_averaged: false,
        is_measured: false,
        preset: Some("modern-driver"),
        data_name: "chart-optima",
    },
    Set {
        name: "chart-optima-impact",
        title: "TrackMan's driver chart, its optima with the club of lpga-average",
        about: "The rows of chart-optima with the club of lpga-average, which gives the chart's \
                ratio of launch angle to spin.",
        air: NOT_STATED,
        misses: CHART,
        computation: Computation::Optimum,
        is_averaged: false,
        is_measured: false,
        preset: Some("lpga-average"),
        data_name: "chart-optima",
    },
    Set {
        name: "simulations",
        title: "Published simulations",
        about: "Eight drives that others computed: Winfield & Tan, Stengel, TrackMan's 6 irons, a \
                patent, Nathan's calculator.",
        air: "stated for two drives, which are flown in this air; not stated for the others",
        misses: "The drives come from models, each with its own law. All are flown with the ball \
                 of modern-driver.",
        computation: Computation::Launch,
        is_averaged: false,
        is_measured: false,
        preset: None,
        data_name: "simulations",
    },
];
