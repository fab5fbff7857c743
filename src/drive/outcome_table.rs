//! The table of outcomes: the formula and the declaration of every outcome.

use super::declaration::{ComputedFrom, Declaration, Instrument, Sign};
use crate::flight::Landed;
use crate::impact::Head;
use crate::launch::Launch;
use crate::number::Number;
use crate::parameters::Range;
use crate::units::Quantity;

/// Parts of a drive that outcomes are computed from.
pub(crate) struct OutcomeInputs<'a, T> {
    pub launch: &'a Launch<T>,
    /// Speed of the head before impact, m/s, if there is a club.
    pub club_speed: Option<T>,
    pub landed: Option<&'a Landed<T>>,
    /// The head, if there is a club and if an outcome of the head is requested.
    pub head: Option<&'a Head<T>>,
}

/// Uncertainty of ball speed, from golflaunchlab.com/guides/golf-launch-monitor-accuracy (read in a
/// stored copy). Two better sources could not be read: a maker's data sheet, and the numbers of
/// Leach, Forrester, Mears & Roberts (Measurement 112, 2017, 125–136).
const BALL_SPEED_SOURCE: &str = "two radar units agree to about 0.5 % (golflaunchlab.com, a guide \
                                 that names no test): {0.8 mph} of {165 mph}, rounded up";
/// Uncertainty of launch angles: no source was found.
const LAUNCH_ANGLE_SOURCE: &str = "assumed: three times the resolution of exports, 0.1°";
/// Uncertainty of spin: no source was found.
const SPIN_SOURCE: &str = "assumed: 4 % of a driver's 2500 rpm";
/// Uncertainty of distances: the difference between launch monitors for the same launch.
const CARRY_SOURCE: &str = "for the same launch, launch monitors predict carries within about \
                            {3 yd} of each other (docs/sources.md)";
/// Uncertainty of totals: the differences between two monitors on the same shots (Bliss & Langdown
/// 2026). The ground models of the monitors differ.
const TOTAL_SOURCE: &str = "the totals of two monitors on the same shots differ by {11.5 yd} (one \
                            standard deviation): {8 yd} each, docs/sources.md";
/// Uncertainty of apex height and descent angle: published averages are rounded to whole yards and
/// degrees.
const WHOLE_UNITS_SOURCE: &str = "assumed: tables print whole units of length and whole degrees; \
                                  indoors both are computed from the launch";

/// Declares the outcomes: for each a variant with its formula and its [`Declaration`].
macro_rules! outcomes {
    ($(
        $(#[doc = $doc:literal])+
        $Outcome:ident {
            value: |$drive:ident| $value:expr,
            name: $name:literal,
            symbol: $symbol:literal,
            $($field:ident: $fact:expr,)+
        }
    )+) => {
        /// An outcome of a drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Outcome {
            $(
                $(#[doc = $doc])+
                #[doc = concat!("\n\n`", $name, "`, symbol ", $symbol, ".")]
                $Outcome,
            )+
        }

        impl Outcome {
            /// Outcomes of drives, then outcomes of the head.
            pub(super) const ALL: &'static [Self] = &[$( Self::$Outcome ),+];

            /// Facts about the outcome.
            pub(super) const fn declaration(self) -> &'static Declaration {
                match self {
                    $( Self::$Outcome => const {
                        &Declaration {
                            name: $name,
                            symbol: $symbol,
                            doc: concat!($($doc),+).trim_ascii(),
                            $( $field: $fact, )+
                        }
                    }, )+
                }
            }

            /// Evaluates the outcome; `None` if a quantity that it depends on is missing.
            pub(crate) fn evaluate<T: Number>(self, inputs: &OutcomeInputs<'_, T>) -> Option<T> {
                match self {
                    $( Self::$Outcome => {
                        let $drive = inputs;
                        Some($value)
                    } )+
                }
            }
        }
    };
}

outcomes! {
    /// Distance downrange at landing, along the target line; carry_distance includes the distance
    /// to the side.
    Carry {
        value: |drive| drive.landed?.carry,
        name: "carry",
        symbol: "z_L",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Landing,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "3 yd",
            source: CARRY_SOURCE,
            plausible: None,
            column_heads: &[],
        }),
    }

    /// Horizontal distance from the tee to the landing, in any direction: the carry of launch
    /// monitors.
    CarryDistance {
        value: |drive| {
            let landed = drive.landed?;
            (landed.carry * landed.carry + landed.lateral * landed.lateral).sqrt()
        },
        name: "carry_distance",
        symbol: "√(z_L² + y_L²)",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Landing,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "3 yd",
            source: CARRY_SOURCE,
            plausible: Some(Range::above_to(0.0, 600.0)),
            column_heads: &[
                "carry",
                "carry distance",
                "carry flat length",
                "carry length",
                "carry distanz",
            ],
        }),
    }

    /// Distance right of the target line at landing.
    Lateral {
        value: |drive| drive.landed?.lateral,
        name: "lateral",
        symbol: "y_L",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Landing,
        sign: Sign::Right,
        instrument: Some(Instrument {
            sigma: "3 yd",
            source: "assumed: 0.7 deg of direction at {250 yd}",
            plausible: Some(Range::from_to(-600.0, 600.0)),
            column_heads: &[
                "side",
                "carry side",
                "side carry",
                "carry lateral distance",
                "lateral landing",
                "carry flat side",
                "carry deviation distance",
                "offline",
                "lateral",
                "carry abweichungsdistanz",
            ],
        }),
    }

    /// Time from launch to landing.
    FlightTime {
        value: |drive| drive.landed?.flight_time,
        name: "flight_time",
        symbol: "t_L",
        quantity: Quantity::TIME,
        unit: "s",
        computed_from: ComputedFrom::Landing,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "0.1 s",
            source: "assumed: tables print tenths of a second; indoors times are computed from the \
                launch",
            plausible: Some(Range::above_to(0.0, 20.0)),
            column_heads: &["hang time", "flight time", "carry flat time"],
        }),
    }

    /// Greatest height of the flight above the tee.
    ApexHeight {
        value: |drive| drive.landed?.apex?.height,
        name: "apex_height",
        symbol: "x_A",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::ApexHeight,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "1 yd",
            source: WHOLE_UNITS_SOURCE,
            plausible: Some(Range::above_to(0.0, 150.0)),
            column_heads: &[
                "apex",
                "apex height",
                "max height",
                "max height height",
                "ball apex",
                "peak height",
                "height",
                "höhe des scheitelpunkts",
            ],
        }),
    }

    /// Time from launch to the apex.
    ApexTime {
        value: |drive| drive.landed?.apex?.time,
        name: "apex_time",
        symbol: "t_A",
        quantity: Quantity::TIME,
        unit: "s",
        computed_from: ComputedFrom::ApexTime,
        sign: Sign::Either,
        instrument: Some(Instrument {
            sigma: "0.1 s",
            source: "assumed: as for flight_time",
            plausible: None,
            column_heads: &[],
        }),
    }

    /// Distance downrange of the apex.
    ApexDownrange {
        value: |drive| drive.landed?.apex?.downrange,
        name: "apex_downrange",
        symbol: "z_A",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::ApexTime,
        sign: Sign::Either,
        instrument: Some(Instrument {
            sigma: "3 yd",
            source: "assumed: as for carry",
            plausible: None,
            column_heads: &["max height dist"],
        }),
    }

    /// Angle of the path below horizontal at landing.
    DescentAngle {
        value: |drive| {
            let v = drive.landed?.velocity;
            (-v.x).atan2((v.y * v.y + v.z * v.z).sqrt())
        },
        name: "descent_angle",
        symbol: "γ_L",
        quantity: Quantity::ANGLE,
        unit: "deg",
        computed_from: ComputedFrom::LandingVelocity,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "1 deg",
            source: WHOLE_UNITS_SOURCE,
            plausible: Some(Range::above_to(0.0, 90.0)),
            column_heads: &[
                "landing angle",
                "landing ang",
                "land ang",
                "land angle",
                "carry flat land angle",
                "descent angle",
                "descent v",
                "descentv",
                "angle of descent",
                "ball descent angle",
                "vertical descent",
            ],
        }),
    }

    /// Speed at landing.
    LandingSpeed {
        value: |drive| drive.landed?.velocity.norm(),
        name: "landing_speed",
        symbol: "|v_L|",
        quantity: Quantity::SPEED,
        unit: "mph",
        computed_from: ComputedFrom::LandingVelocity,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "1 mph",
            source: "assumed: as for ball_speed",
            plausible: Some(Range::from_to(0.0, 270.0)),
            column_heads: &["carry flat ball speed"],
        }),
    }

    /// Distance downrange where the ball rests, along the target line like carry; uncertain by at
    /// least 10 yd, as the ground is not calibrated.
    Total {
        value: |drive| drive.landed?.rest.as_ref()?.downrange,
        name: "total",
        symbol: "z_R",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Rest,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "8 yd",
            source: TOTAL_SOURCE,
            plausible: Some(Range::above_to(0.0, 800.0)),
            column_heads: &[
                "gesamtstrecke",
                "total",
                "total distance",
                "total length",
                "est total flat length",
            ],
        }),
    }

    /// Distance from landing to rest (bounces, sliding, rolling), along the target line; uncertain
    /// by at least 10 yd, as the ground is not calibrated.
    Run {
        value: |drive| {
            let landed = drive.landed?;
            landed.rest.as_ref()?.downrange - landed.carry
        },
        name: "run",
        symbol: "z_R − z_L",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Rest,
        sign: Sign::Either,
        instrument: Some(Instrument {
            sigma: "8 yd",
            source: TOTAL_SOURCE,
            plausible: None,
            column_heads: &[],
        }),
    }

    /// Distance right of the target line where the ball rests; the ground is not calibrated.
    LateralTotal {
        value: |drive| drive.landed?.rest.as_ref()?.right,
        name: "lateral_total",
        symbol: "y_R",
        quantity: Quantity::LENGTH,
        unit: "yd",
        computed_from: ComputedFrom::Rest,
        sign: Sign::Right,
        instrument: Some(Instrument {
            sigma: "8 yd",
            source: "assumed: as for total",
            plausible: Some(Range::from_to(-800.0, 800.0)),
            column_heads: &[
                "gesamtabweichungsdistanz",
                "total offline",
                "total side",
                "side total",
                "total deviation distance",
                "est total flat side",
            ],
        }),
    }

    /// Speed of the ball at launch.
    BallSpeed {
        value: |drive| drive.launch.ball_speed(),
        name: "ball_speed",
        symbol: "|v_0|",
        quantity: Quantity::SPEED,
        unit: "mph",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "1 mph",
            source: BALL_SPEED_SOURCE,
            // the fastest recorded ball speed is 241.7 mph (108 m/s)
            plausible: Some(Range::above_to(0.0, 270.0)),
            column_heads: &["ball speed", "ballgeschwindigkeit"],
        }),
    }

    /// Ball speed over club speed.
    SmashFactor {
        value: |drive| drive.launch.ball_speed() / drive.club_speed?,
        name: "smash_factor",
        symbol: "|v_0|/V",
        quantity: Quantity::NUMBER,
        unit: "",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Positive,
        instrument: Some(Instrument {
            sigma: "0.02",
            source: "assumed: {1 mph} of ball speed and {1.5 mph} of club speed, for a ratio of 1.48",
            plausible: None,
            column_heads: &["smash factor", "smash", "smash fac"],
        }),
    }

    /// Angle of the launch above horizontal.
    LaunchAngle {
        value: |drive| drive.launch.launch_angle(),
        name: "launch_angle",
        symbol: "γ_0",
        quantity: Quantity::ANGLE,
        unit: "deg",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Either,
        instrument: Some(Instrument {
            sigma: "0.3 deg",
            source: LAUNCH_ANGLE_SOURCE,
            plausible: Some(Range::from_to(-90.0, 90.0)),
            column_heads: &[
                "launch angle",
                "launch ang",
                "launch v",
                "vertical launch",
                "vertical launch angle",
                "launch angle v",
                "v launch angle",
                "vla",
                "abflugwinkel",
            ],
        }),
    }

    /// Horizontal direction of the launch, + right.
    LaunchDirection {
        value: |drive| drive.launch.launch_direction(),
        name: "launch_direction",
        symbol: "φ_0",
        quantity: Quantity::ANGLE,
        unit: "deg",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Right,
        instrument: Some(Instrument {
            sigma: "0.3 deg",
            source: LAUNCH_ANGLE_SOURCE,
            plausible: Some(Range::from_to(-90.0, 90.0)),
            column_heads: &[
                "launch direction",
                "launch dir",
                "launch h",
                "horizontal launch",
                "horizontal launch angle",
                "launch angle h",
                "h launch angle",
                "hla",
                "push pull",
                "side angle",
                "azimuth",
                "abflugrichtung",
            ],
        }),
    }

    /// Spin at launch.
    Spin {
        value: |drive| drive.launch.total_spin(),
        name: "spin",
        symbol: "|ω_0|",
        quantity: Quantity::ANGULAR_VELOCITY,
        unit: "rpm",
        computed_from: ComputedFrom::Launch,
        sign: Sign::NotNegative,
        instrument: Some(Instrument {
            sigma: "100 rpm",
            source: SPIN_SOURCE,
            plausible: Some(Range::above_to(0.0, 20_000.0)),
            column_heads: &["spin rate", "total spin", "spin", "drehrate"],
        }),
    }

    /// Backspin at launch.
    Backspin {
        value: |drive| drive.launch.backspin(),
        name: "backspin",
        symbol: "ω_b",
        quantity: Quantity::ANGULAR_VELOCITY,
        unit: "rpm",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Either,
        instrument: Some(Instrument {
            sigma: "100 rpm",
            source: SPIN_SOURCE,
            // a driver gives no topspin
            plausible: Some(Range::from_to(0.0, 20_000.0)),
            column_heads: &["backspin", "back spin"],
        }),
    }

    /// Sidespin at launch, + curves right.
    Sidespin {
        value: |drive| drive.launch.sidespin(),
        name: "sidespin",
        symbol: "ω_s",
        quantity: Quantity::ANGULAR_VELOCITY,
        unit: "rpm",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Right,
        instrument: Some(Instrument {
            sigma: "100 rpm",
            source: "assumed: as for spin",
            plausible: Some(Range::from_to(-20_000.0, 20_000.0)),
            column_heads: &["sidespin", "side spin"],
        }),
    }

    /// Tilt of the spin axis at launch, + right.
    SpinAxis {
        value: |drive| drive.launch.spin_axis(),
        name: "spin_axis",
        symbol: "atan2(ω_s, ω_b)",
        quantity: Quantity::ANGLE,
        unit: "deg",
        computed_from: ComputedFrom::Launch,
        sign: Sign::Right,
        instrument: Some(Instrument {
            sigma: "2 deg",
            source: "assumed: 100 rpm of sidespin turn the axis of a spin of 2700 rpm by 2.1 deg",
            plausible: Some(Range::from_to(-180.0, 180.0)),
            column_heads: &["spin axis", "spin tilt axis", "tilt angle", "axis tilt", "drehachse"],
        }),
    }

    /// Mass of the head with its movable weights.
    HeadMass {
        value: |drive| drive.head?.mass,
        name: "head_mass",
        symbol: "M",
        quantity: Quantity::MASS,
        unit: "g",
        computed_from: ComputedFrom::Head,
        sign: Sign::Either,
        instrument: None,
    }

    /// Moment of inertia of the head with its movable weights about the vertical axis through its
    /// centre of mass, which the Rules of Golf limit.
    HeadMoi {
        value: |drive| drive.head?.inertia[0][0],
        name: "head_moi",
        symbol: "I_xx",
        quantity: Quantity::INERTIA,
        unit: "g cm^2",
        computed_from: ComputedFrom::Head,
        sign: Sign::Either,
        instrument: None,
    }

    /// First leading minor of the second moments of the head's mass: at least 0 for a rigid body.
    HeadMinor1 {
        value: |drive| drive.head?.minors()[0],
        name: "head_minor_1",
        symbol: "S₁",
        quantity: Quantity::INERTIA,
        unit: "g cm^2",
        computed_from: ComputedFrom::Head,
        sign: Sign::Either,
        instrument: None,
    }

    /// Leading 2 × 2 minor of the matrix of the head's second moments of mass, divided by the trace
    /// of the matrix: at least 0 for a rigid body.
    HeadMinor2 {
        value: |drive| drive.head?.minors()[1],
        name: "head_minor_2",
        symbol: "S₂",
        quantity: Quantity::INERTIA,
        unit: "g cm^2",
        computed_from: ComputedFrom::Head,
        sign: Sign::Either,
        instrument: None,
    }

    /// Determinant of the matrix of the head's second moments of mass, divided by the square of the
    /// trace: at least 0 for a rigid body.
    HeadMinor3 {
        value: |drive| drive.head?.minors()[2],
        name: "head_minor_3",
        symbol: "S₃",
        quantity: Quantity::INERTIA,
        unit: "g cm^2",
        computed_from: ComputedFrom::Head,
        sign: Sign::Either,
        instrument: None,
    }
}
