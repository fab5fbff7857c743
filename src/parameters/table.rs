//! The parameter table: each scalar of the model, declared once.
//!
//! A row is its documentation and `field: type = name, symbol, quantity in unit, range, default,
//! source of the default`. The type is `T`, `Option<T>` for a parameter that may be unset (`or 0.0`
//! if it counts as 0 while unset), or `f64` for a setting of the computation. The defaults are the
//! preset `modern-driver`; the ranges are physically possible values. `declare.rs` shows the struct
//! that a row expands to.

use super::choices::{Golfer, Method, SpeedOf};
use super::declare::{Kind, Parameter, ParameterGroup, Slot};
use super::law_table::{LawTable, TABLE_LAW};
use super::range::Range;
use crate::units::Quantity;

parameter_groups! {
    /// The club just before impact.
    swing: Swing {
        /// Speed of the head's centre of mass.
        speed: T = "swing.speed", "V", SPEED in "mph", Range::above_to(0.0, 1000.0),
            "110 mph", "a fast amateur's swing, and the speed Winfield & Tan (1994) optimize at";
        /// Attack angle: the velocity's angle above horizontal (Winfield & Tan's swing elevation).
        /// The head pitches with it, so it adds to the loft.
        attack_angle: T = "swing.attack_angle", "ε", ANGLE in "deg", Range::within_degrees(90.0),
            "-0.9 deg", "TrackMan, PGA TOUR averages 2023, driver";
        /// Horizontal direction of the velocity, + outwards: to the right, or to the left for a
        /// left-hander.
        path: T = "swing.path", "χ", ANGLE in "deg", Range::within_degrees(90.0),
            "0 deg", "straight swing";
        /// Yaw of the head, + open: to the right, or to the left for a left-hander.
        face_angle: T = "swing.face_angle", "ψ", ANGLE in "deg", Range::within_degrees(90.0),
            "0 deg", "square face";
        /// Forward lean of the shaft, which reduces the loft.
        shaft_lean: T = "swing.shaft_lean", "σ", ANGLE in "deg", Range::within_degrees(90.0),
            "0 deg", "Winfield & Tan (1994): none";
        /// Forward bend of the shaft at impact, at a head speed of 100 mph: it adds to the loft;
        /// unset: 0.
        shaft_bend: Option<T> or 0.0 = "swing.shaft_bend", "β", ANGLE in "deg",
            Range::within_degrees(45.0),
            "none", "a rigid shaft; drivers are taken to bend by 2 to 5 deg, docs/sources.md";
        /// Droop of the shaft at impact, at a head speed of 100 mph: it turns the toe down; unset:
        /// 0.
        shaft_droop: Option<T> or 0.0 = "swing.shaft_droop", "δ_s", ANGLE in "deg",
            Range::within_degrees(45.0),
            "none", "a rigid shaft; drivers are taken to droop by 1 to 4 deg, docs/sources.md";
        /// Exponent of bend and droop in the head speed V: both are proportional to V to this
        /// power; unset: 0.
        shaft_growth: Option<T> or 0.0 = "swing.shaft_growth", "p_s", NUMBER in "",
            Range::from_to(0.0, 4.0),
            "none",
            "the same bend at every head speed; 2 for a load in proportion to V² on a shaft \
             whose stiffness stays";
        /// Head's angular velocity before impact, about the vertical; + closes the face.
        closure_x: T = "swing.closure.x", "ω_cx", ANGULAR_VELOCITY in "rad/s",
            Range::from_to(-1e4, 1e4),
            "0 rad/s", "Winfield & Tan (1994): none";
        /// Head's angular velocity before impact, about the axis to the right; + pitches the face
        /// upwards.
        closure_y: T = "swing.closure.y", "ω_cy", ANGULAR_VELOCITY in "rad/s",
            Range::from_to(-1e4, 1e4),
            "0 rad/s", "Winfield & Tan (1994): none";
        /// Head's angular velocity before impact, about the downrange axis.
        closure_z: T = "swing.closure.z", "ω_cz", ANGULAR_VELOCITY in "rad/s",
            Range::from_to(-1e4, 1e4),
            "0 rad/s", "Winfield & Tan (1994): none";
    }

    /// Impact point on the face.
    strike: Strike {
        /// Impact point above the sweet spot, or above the centre of the face where club.cg_high,
        /// club.cg_toe or a movable weight is set.
        high: T = "strike.high", "r₁", LENGTH in "mm", Range::from_to(-0.2, 0.2),
            "0 mm", "sweet spot";
        /// Impact point towards the toe from the sweet spot, or from the centre of the face where
        /// club.cg_high, club.cg_toe or a movable weight is set.
        toe: T = "strike.toe", "r₂", LENGTH in "mm", Range::from_to(-0.2, 0.2),
            "0 mm", "sweet spot";
    }

    /// The clubhead.
    club: Club {
        /// Mass of the head.
        mass: T = "club.mass", "M", MASS in "g", Range::from_to(0.05, 2.0),
            "204 g", "Caldwell & McPhee (2024), a driver of the 2020s";
        /// Loft at the sweet spot, or at the centre of the face where club.cg_high, club.cg_toe or a
        /// movable weight is set.
        loft: T = "club.loft", "λ", ANGLE in "deg", Range::within_degrees(90.0),
            "9.8 deg", "McNally (2016), measured driver";
        /// Moment of inertia about the vertical axis through the centre of mass, the MOI of golf:
        /// entry xx of the inertia tensor in the head frame.
        inertia_xx: T = "club.inertia.xx", "I_xx", INERTIA in "g cm^2", Range::above_to(0.0, 1.0),
            "5679 g cm^2", "measured driver, docs/sources.md";
        /// Moment of inertia about the axis from heel to toe: entry yy of the inertia tensor.
        inertia_yy: T = "club.inertia.yy", "I_yy", INERTIA in "g cm^2", Range::above_to(0.0, 1.0),
            "4085 g cm^2", "measured driver, docs/sources.md";
        /// Moment of inertia about the target line: entry zz of the inertia tensor.
        inertia_zz: T = "club.inertia.zz", "I_zz", INERTIA in "g cm^2", Range::above_to(0.0, 1.0),
            "2843 g cm^2", "measured driver, docs/sources.md";
        /// Inertia tensor, matrix entry xy (minus the product of inertia).
        inertia_xy: T = "club.inertia.xy", "I_xy", INERTIA in "g cm^2", Range::from_to(-1.0, 1.0),
            "0 g cm^2", "head symmetric about the X-Z plane";
        /// Inertia tensor, matrix entry xz (minus the product of inertia).
        inertia_xz: T = "club.inertia.xz", "I_xz", INERTIA in "g cm^2", Range::from_to(-1.0, 1.0),
            "-733 g cm^2", "measured driver, docs/sources.md";
        /// Inertia tensor, matrix entry yz (minus the product of inertia).
        inertia_yz: T = "club.inertia.yz", "I_yz", INERTIA in "g cm^2", Range::from_to(-1.0, 1.0),
            "0 g cm^2", "head symmetric about the X-Z plane";
        /// Distance from the centre of mass to the face, along the face normal at the point to which
        /// club.loft refers.
        cg_depth: T = "club.cg_depth", "d", LENGTH in "mm", Range::from_to(0.0, 0.5),
            "40.8 mm", "measured driver, docs/sources.md";
        /// Bulge: the face's radius of curvature from heel to toe; inf for a flat face.
        bulge_radius: T = "club.bulge_radius", "R_b", LENGTH in "mm",
            Range::above_to(0.0, f64::INFINITY),
            "305 mm", "measured driver (12 in), docs/sources.md";
        /// Roll: the face's radius of curvature from crown to sole; inf for a flat face.
        roll_radius: T = "club.roll_radius", "R_r", LENGTH in "mm",
            Range::above_to(0.0, f64::INFINITY),
            "305 mm", "measured driver (12 in), docs/sources.md";
        /// Third semi-axis of the face's ellipsoid; unset: √(R_b R_r).
        face_semi_axis: Option<T> = "club.face_semi_axis", "P_k", LENGTH in "mm",
            Range::above_to(0.0, f64::INFINITY),
            "none", "√(R_b R_r): a sphere where bulge and roll are equal";
        /// Centre of mass above the centre of the face, along the face; strikes are then measured
        /// from the centre of the face; unset: 0.
        cg_high: Option<T> or 0.0 = "club.cg_high", "c₁", LENGTH in "mm", Range::from_to(-0.1, 0.1),
            "none", "the centre of mass lies behind the centre of the face";
        /// Distance of the centre of mass from the centre of the face, towards the toe. If set,
        /// strikes are measured from the centre of the face; unset: 0.
        cg_toe: Option<T> or 0.0 = "club.cg_toe", "c₂", LENGTH in "mm", Range::from_to(-0.1, 0.1),
            "none", "the centre of mass lies behind the centre of the face";
        /// Mass of the first movable weight, in addition to club.mass; unset: 0.
        weight_1_mass: Option<T> or 0.0 = "club.weight_1.mass", "M₁", MASS in "g",
            Range::from_to(0.0, 0.5),
            "none", "no movable weight";
        /// Position of the first movable weight behind the face, along the normal at the face
        /// centre; unset: 0.
        weight_1_depth: Option<T> or 0.0 = "club.weight_1.depth", "d₁", LENGTH in "mm",
            Range::from_to(-0.1, 0.5),
            "none", "no movable weight";
        /// Position of the first movable weight towards the toe from the face centre; unset: 0.
        weight_1_toe: Option<T> or 0.0 = "club.weight_1.toe", "y₁", LENGTH in "mm",
            Range::from_to(-0.2, 0.2),
            "none", "no movable weight";
        /// Position of the first movable weight above the face centre, along the face; unset: 0.
        weight_1_high: Option<T> or 0.0 = "club.weight_1.high", "x₁", LENGTH in "mm",
            Range::from_to(-0.2, 0.2),
            "none", "no movable weight";
        /// Mass of the second movable weight, in addition to club.mass; unset: 0.
        weight_2_mass: Option<T> or 0.0 = "club.weight_2.mass", "M₂", MASS in "g",
            Range::from_to(0.0, 0.5),
            "none", "no movable weight";
        /// Position of the second movable weight behind the face, along the normal at the face
        /// centre; unset: 0.
        weight_2_depth: Option<T> or 0.0 = "club.weight_2.depth", "d₂", LENGTH in "mm",
            Range::from_to(-0.1, 0.5),
            "none", "no movable weight";
        /// Position of the second movable weight towards the toe from the face centre; unset: 0.
        weight_2_toe: Option<T> or 0.0 = "club.weight_2.toe", "y₂", LENGTH in "mm",
            Range::from_to(-0.2, 0.2),
            "none", "no movable weight";
        /// Position of the second movable weight above the face centre, along the face; unset: 0.
        weight_2_high: Option<T> or 0.0 = "club.weight_2.high", "x₂", LENGTH in "mm",
            Range::from_to(-0.2, 0.2),
            "none", "no movable weight";
    }

    /// The ball.
    ball: Ball {
        /// Mass.
        mass: T = "ball.mass", "m", MASS in "g", Range::above_to(0.0, 1.0),
            "45.93 g", "Rules of Golf: the heaviest ball allowed";
        /// Radius.
        radius: T = "ball.radius", "R", LENGTH in "mm", Range::above_to(0.0, 0.5),
            "21.335 mm", "Rules of Golf: the smallest ball allowed";
        /// Moment of inertia; unset: 2/5 m R², a homogeneous ball.
        inertia: Option<T> = "ball.inertia", "I_b", INERTIA in "g cm^2", Range::above_to(0.0, 1.0),
            "none", "2/5 m R²; measured 83.4 g cm², docs/sources.md";
    }

    /// The contact between club and ball.
    impact: Contact {
        /// Coefficient of restitution along the face normal.
        restitution: T = "impact.restitution", "e", NUMBER in "", Range::from_to(0.0, 1.0),
            "0.83", "USGA limit 0.822 + 0.008, which modern drivers reach";
        /// Change of the restitution with the closing speed along the normal; if set,
        /// impact.restitution holds at 160 ft/s, the speed of the USGA's test; unset: 0.
        restitution_slope: Option<T> or 0.0 = "impact.restitution_slope", "e_v", PER_SPEED in "s/m",
            Range::from_to(-0.1, 0.1),
            "none",
            "the same restitution at every speed; −0.0029 s/m for a solid plate in Penner \
             (2001), after Lieberman & Johnson";
        /// Tangential coefficient of restitution: 0 no slip at exit, −1 a frictionless face, 1
        /// elastic.
        tangential_restitution: T = "impact.tangential_restitution", "e_t", NUMBER in "",
            Range::from_to(-1.0, 1.0),
            "-0.1",
            "measured drivers spin less than rolling predicts: −0.1 ± 0.06, docs/sources.md";
        /// Coefficient of friction; unset: the ball never slips.
        friction: Option<T> = "impact.friction", "μ_f", NUMBER in "", Range::from_to(0.0, 100.0),
            "none", "a driver does not slip, docs/sources.md";
        /// Scale of the gear effect: factor of the velocity along the face that the turning of the
        /// head causes; unset: 1, as for rigid bodies.
        gear_scale: Option<T> = "impact.gear_scale", "g", NUMBER in "", Range::from_to(0.0, 2.0),
            "0.75",
            "measured drives: 0.75 ± 0.2 of the gear effect of rigid bodies, docs/sources.md";
    }

    /// Launch conditions, as measured by a launch monitor. If `launch.ball_speed` is set, no club
    /// strikes the ball, and nothing depends on swing, strike, club and impact.
    launch: LaunchConditions {
        /// Ball speed at launch; unset: the club strikes the ball.
        ball_speed: Option<T> = "launch.ball_speed", "|v_0|", SPEED in "mph",
            Range::above_to(0.0, 1000.0),
            "none", "the club strikes the ball";
        /// Launch angle above horizontal.
        launch_angle: Option<T> = "launch.launch_angle", "γ_0", ANGLE in "deg",
            Range::within_degrees(90.0),
            "none", "the club strikes the ball";
        /// Launch direction, + right; unset: 0.
        launch_direction: Option<T> or 0.0 = "launch.launch_direction", "φ_0", ANGLE in "deg",
            Range::within_degrees(180.0),
            "none", "the target line";
        /// Backspin at launch.
        backspin: Option<T> = "launch.backspin", "ω_b", ANGULAR_VELOCITY in "rpm",
            Range::from_to(-1e5, 1e5),
            "none", "the club strikes the ball, or launch.spin is given";
        /// Sidespin at launch, + curves right; unset: 0.
        sidespin: Option<T> or 0.0 = "launch.sidespin", "ω_s", ANGULAR_VELOCITY in "rpm",
            Range::from_to(-1e5, 1e5),
            "none", "no sidespin";
        /// Total spin at launch, in place of backspin and sidespin.
        spin: Option<T> = "launch.spin", "|ω_0|", ANGULAR_VELOCITY in "rpm",
            Range::from_to(0.0, 1e5),
            "none", "the club strikes the ball, or launch.backspin is given";
        /// Tilt of the spin axis at launch, + right, given with launch.spin; unset: 0.
        spin_axis: Option<T> or 0.0 = "launch.spin_axis", "atan2(ω_s, ω_b)", ANGLE in "deg",
            Range::within_degrees(180.0),
            "none", "a level axis";
    }

    /// The air.
    air: Air {
        /// Density; 0 is a vacuum. If temperature, pressure, altitude or humidity is set, the
        /// density follows from them.
        density: T = "air.density", "ρ", DENSITY in "kg/m^3", Range::from_to(0.0, 1000.0),
            "1.184 kg/m^3", "25 °C at sea level, TrackMan's normalized air";
        /// Dynamic viscosity. If temperature, pressure, altitude or humidity is set, the viscosity
        /// follows from the temperature.
        viscosity: T = "air.viscosity", "μ", VISCOSITY in "Pa s", Range::above_to(0.0, 1.0),
            "1.837e-5 Pa s", "Sutherland's formula at 25 °C, docs/sources.md";
        /// Temperature; unset: 25 °C if other weather is set.
        temperature: Option<T> = "air.temperature", "T", TEMPERATURE in "degC",
            Range::from_to(183.15, 333.15),
            "none", "density and viscosity are given, or other weather; the range is −90 to 60 °C";
        /// Pressure on the course, not reduced to sea level; unset: the pressure of the altitude if
        /// other weather is set.
        pressure: Option<T> = "air.pressure", "p", PRESSURE in "hPa",
            Range::from_to(22_000.0, 115_000.0),
            "none",
            "density and viscosity are given, or other weather; the range follows from the altitudes";
        /// Altitude above sea level, from which the standard atmosphere gives the pressure; unset:
        /// 0 m if other weather is set.
        altitude: Option<T> = "air.altitude", "H", LENGTH in "ft",
            Range::from_to(-1000.0, 11_000.0),
            "none",
            "density and viscosity are given, or other weather; the troposphere of ISO 2533 ends at \
             11 km";
        /// Relative humidity; unset: dry air if other weather is set.
        humidity: Option<T> = "air.humidity", "h_r", NUMBER in "", Range::from_to(0.0, 1.0),
            "none", "density and viscosity are given, or other weather";
    }

    /// Decay of the spin in the air; the coefficients of drag and lift belong to the law.
    aero: Aero {
        /// Decay rate of the spin in time: ω ∝ exp(−δ t).
        spin_decay: T = "aero.spin_decay", "δ", RATE in "1/s", Range::from_to(0.0, 100.0),
            "0.03 1/s",
            "TrackMan, driver: 3.1, 8.8 and 12.8 % lost in 1, 3 and 5 s (US patent 8016695, \
             table 6B)";
        /// Decay of the spin with the distance through the air: dω/dt = −κ ω |v_r|/R on top of δ;
        /// unset: 0.
        spin_damping: Option<T> or 0.0 = "aero.spin_damping", "κ", NUMBER in "",
            Range::from_to(0.0, 1.0),
            "none", "2.0e-5 in Smits & Smith (1994), Penner (2001) eq. 16";
    }

    /// The wind: the air's velocity over the ground, uniform or with a logarithmic profile in
    /// height.
    wind: Wind {
        /// Upward component.
        up: T = "wind.up", "w_x", SPEED in "m/s", Range::from_to(-150.0, 150.0), "0 m/s", "calm";
        /// Component to the right.
        right: T = "wind.right", "w_y", SPEED in "m/s", Range::from_to(-150.0, 150.0),
            "0 m/s", "calm";
        /// Downrange component: + tail wind, − head wind.
        downrange: T = "wind.downrange", "w_z", SPEED in "m/s", Range::from_to(-150.0, 150.0),
            "0 m/s", "calm";
        /// Horizontal speed, in place of wind.right and wind.downrange; negative for the opposite
        /// direction; unset: wind.right and wind.downrange give the wind.
        speed: Option<T> = "wind.speed", "w_h", SPEED in "m/s", Range::from_to(-150.0, 150.0),
            "none", "the components are given";
        /// Direction that the wind comes from, clockwise from the target line: 0° is a head wind,
        /// 90° from the right, 180° a tail wind; unset: wind.right and wind.downrange give the
        /// wind.
        from: Option<T> = "wind.from", "β", ANGLE in "deg",
            Range::from_to((-360.0_f64).to_radians(), 360.0_f64.to_radians()),
            "none", "the components are given";
        /// Roughness length of the ground under a logarithmic wind profile; unset: uniform wind.
        roughness: Option<T> = "wind.roughness", "z₀", LENGTH in "mm", Range::above_to(0.0, 10.0),
            "none", "2.4 mm mown grass to 30 mm open course, docs/sources.md";
        /// Height above the ground at which a logarithmic profile has the stated wind.
        reference_height: T = "wind.reference_height", "z_ref", LENGTH in "m",
            Range::above_to(0.0, 1000.0),
            "10 m", "meteorological practice";
    }

    /// The ground.
    ground: Ground {
        /// Height of the landing area above the tee.
        height: T = "ground.height", "h_g", LENGTH in "m", Range::from_to(-10000.0, 10000.0),
            "0 m", "level ground";
        /// Restitution of the turf for a slow impact; a fast impact has less; unset: the ball
        /// embeds where it lands and does not run.
        restitution: Option<T> = "ground.restitution", "e_g", NUMBER in "",
            Range::from_to(0.0, 1.0),
            "0.51", "Penner (2002)";
        /// Coefficient of friction between the ball and the turf.
        friction: T = "ground.friction", "μ_g", NUMBER in "", Range::above_to(0.0, 10.0),
            "0.4", "Penner (2002)";
        /// Compliance of the turf: tilt of the crater of a ball that lands at 18.6 m/s, 44.4° from
        /// the vertical, by Penner's formula; the model tilts the craters of flat impacts less.
        compliance: T = "ground.compliance", "θ_g", ANGLE in "deg",
            Range::from_to(0.0, 60.0_f64.to_radians()),
            "15.4 deg", "Penner (2002), from what Haake (1987) measured on greens";
        /// Deceleration of a rolling ball on level ground, in units of gravity.
        rolling: T = "ground.rolling", "ρ_g", NUMBER in "", Range::above_to(0.0, 10.0),
            "1", "Penner (2001), of drives on a fairway; on a green 0.094 (Penner 2002)";
        /// Slope of the landing area downrange from the landing point, + uphill.
        slope: T = "ground.slope", "β_z", ANGLE in "deg", Range::within_degrees(45.0),
            "0 deg", "level ground";
        /// Slope of the landing area to the right of the landing point, + rising.
        side_slope: T = "ground.side_slope", "β_y", ANGLE in "deg", Range::within_degrees(45.0),
            "0 deg", "level ground";
    }

    /// Gravity, and settings of the integration.
    flight: FlightConditions {
        /// Acceleration of gravity.
        gravity: T = "gravity", "g", ACCELERATION in "m/s^2", Range::above_to(0.0, 1000.0),
            "9.80665 m/s^2", "standard gravity";
        // the lower end of the range is 1e-8 of the default time limit: more than 1e8 steps are
        // refused
        /// Time step of the integration.
        step: f64 = "flight.step", "h", TIME in "s", Range::from_to(6e-6, 5.0),
            "0.01 s",
            "carry of ordinary drives within 2e-8 m, in a logarithmic wind within 1e-5 m: \
             docs/model.md, eq. 16";
        /// Longest time of flight that is computed.
        time_limit: f64 = "flight.time_limit", "t_max", TIME in "s", Range::above_to(0.0, 1e6),
            "600 s", "a hundred times an ordinary drive";
    }
}

/// Name of the setting that selects the aerodynamic law: `aero.law = "robinson"`.
pub const LAW: &str = "aero.law";

law_coefficients! { $
    /// Drag and lift depend on the spin only: C_D = cd0 + cd1 |ω|, C_L = cl_max (1 − exp(−cl_rate |ω|)).
    "robinson": Robinson {
        /// Drag coefficient without spin.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.3", "Robinson & Robinson (2013) as the MAE 494 report uses it";
        /// Growth of the drag coefficient with spin.
        cd1: T = "aero.cd1", "cd1", PER_ANGULAR_VELOCITY in "s/rad", Range::FINITE,
            "2.58e-4 s/rad", "Robinson & Robinson (2013) as the MAE 494 report uses it";
        /// Lift coefficient at very high spin.
        cl_max: T = "aero.cl_max", "cl_max", NUMBER in "", Range::FINITE,
            "0.319", "the MAE 494 report's listing (its text prints 0.31)";
        /// Rate at which lift saturates with spin.
        cl_rate: T = "aero.cl_rate", "cl_rate", PER_ANGULAR_VELOCITY in "s/rad",
            Range::from_to(0.0, 10.0),
            "2.48e-3 s/rad", "Robinson & Robinson (2013) as the MAE 494 report uses it";
    }

    /// Constant drag, lift proportional to the spin ratio: C_D = cd, C_L = cl_slope s.
    "linear": Linear {
        /// Drag coefficient.
        cd: T = "aero.cd", "cd", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.25", "a round figure between the values of the laws of docs/sources.md at s = 0.12";
        /// Slope of the lift coefficient in the spin ratio.
        cl_slope: T = "aero.cl_slope", "cl_slope", NUMBER in "", Range::FINITE,
            "1.5", "a round figure between the values of the laws of docs/sources.md at s = 0.12";
    }

    /// C_D = cd1 + cd2 s + cd3 sin(π (Re − re1)/re2), C_L = cl1 s^cl_exp (smoothed below s =
    /// 0.001).
    "smits-smith": SmitsSmith {
        /// Drag coefficient without spin.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.24", "Smits & Smith (1994)";
        /// Growth of the drag coefficient with the spin ratio.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE, "0.18", "Smits & Smith (1994)";
        /// Amplitude of the drag coefficient's variation with the Reynolds number.
        cd3: T = "aero.cd3", "cd3", NUMBER in "", Range::FINITE, "0.06", "Smits & Smith (1994)";
        /// Reynolds number at which the sine in the drag coefficient starts.
        re1: T = "aero.re1", "re1", NUMBER in "", Range::FINITE, "9e4", "Smits & Smith (1994)";
        /// Half the period of the sine in the drag coefficient, as a difference of Reynolds
        /// numbers.
        re2: T = "aero.re2", "re2", NUMBER in "", Range::above_to(0.0, 1e12),
            "2e5", "Smits & Smith (1994)";
        /// Lift coefficient at s = 1.
        cl1: T = "aero.cl1", "cl1", NUMBER in "", Range::FINITE, "0.54", "Smits & Smith (1994)";
        /// Exponent of the spin ratio in the lift coefficient.
        cl_exp: T = "aero.cl_exp", "cl_exp", NUMBER in "", Range::above_to(0.0, 10.0),
            "0.4", "Smits & Smith (1994)";
    }

    /// Quadratics in the spin ratio: C_D = cd0 + cd1 s + cd2 s², C_L = cl0 + cl1 s + cl2 s²
    /// (smoothed below s = 0.02; s held above 0.75).
    "ferguson": Ferguson {
        /// Drag coefficient without spin.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.1304", "Ferguson, McNally & McPhee (2022)";
        /// Coefficient of the spin ratio in the drag coefficient.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::FINITE,
            "0.9287", "Ferguson, McNally & McPhee (2022)";
        /// Coefficient of the squared spin ratio in the drag coefficient.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE,
            "-0.8259", "Ferguson, McNally & McPhee (2022)";
        /// Lift coefficient extrapolated to no spin.
        cl0: T = "aero.cl0", "cl0", NUMBER in "", Range::FINITE,
            "0.0504", "Ferguson, McNally & McPhee (2022)";
        /// Coefficient of the spin ratio in the lift coefficient.
        cl1: T = "aero.cl1", "cl1", NUMBER in "", Range::FINITE,
            "1.2031", "Ferguson, McNally & McPhee (2022)";
        /// Coefficient of the squared spin ratio in the lift coefficient.
        cl2: T = "aero.cl2", "cl2", NUMBER in "", Range::FINITE,
            "-1.1490", "Ferguson, McNally & McPhee (2022)";
    }

    /// Fit to the predictions of launch monitors: C_D = cd0 + cd1 s_c + cd2 s_c² + cd_re (Re/10⁵ − 1.5) with
    /// s_c = s_cap tanh(s/s_cap), and C_L = cl_max cl_rate s/(1 + cl_rate s).
    "launch-monitor": LaunchMonitor {
        /// Drag coefficient without spin at Re = 1.5e5.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.14972", "longdrive: fit to 400 shots of TrackMan's flight model, docs/sources.md";
        /// Coefficient of the capped spin ratio in the drag coefficient.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::FINITE,
            "0.79237", "longdrive: fit, docs/sources.md";
        /// Coefficient of the squared capped spin ratio in the drag coefficient.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE,
            "-0.18328", "longdrive: fit, docs/sources.md";
        /// Coefficient of Re/10⁵ in the drag coefficient.
        cd_re: T = "aero.cd_re", "cd_re", NUMBER in "", Range::FINITE,
            "-0.00201", "longdrive: fit, docs/sources.md";
        /// Cap of the spin ratio in the drag coefficient.
        s_cap: T = "aero.s_cap", "s_cap", NUMBER in "", Range::above_to(0.0, 100.0),
            "0.6", "longdrive: fit, docs/sources.md";
        /// Lift coefficient at very high spin ratio.
        cl_max: T = "aero.cl_max", "cl_max", NUMBER in "", Range::FINITE,
            "0.56282", "longdrive: fit, docs/sources.md";
        /// Rate at which lift saturates with the spin ratio.
        cl_rate: T = "aero.cl_rate", "cl_rate", NUMBER in "", Range::from_to(0.0, 1000.0),
            "4.52866", "longdrive: fit, docs/sources.md";
    }

    /// Recovered from Winfield & Tan's tables: with x = s √(v/50 m/s) and u = (v − 50 m/s)/20 m/s,
    /// C_D = (cd0 + cd1 x + cd2 x² + cd3 x³)(1 + cd_v1 u + cd_v2 u²) and
    /// C_L = (cl_hill x/(x + cl_half) + cl_slope x)/(1 + ((v − cl_speed)/cl_width)²).
    "winfield-tan": WinfieldTan {
        /// Drag coefficient without spin at 50 m/s.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.194599", "longdrive: fit to Winfield & Tan (1994), docs/validation.md";
        /// Coefficient of x in the first factor of the drag coefficient.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::FINITE,
            "0.604802", "longdrive: fit, docs/validation.md";
        /// Coefficient of x² in the first factor of the drag coefficient.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE,
            "-1.346167", "longdrive: fit, docs/validation.md";
        /// Coefficient of x³ in the first factor of the drag coefficient.
        cd3: T = "aero.cd3", "cd3", NUMBER in "", Range::FINITE,
            "7.96419", "longdrive: fit, docs/validation.md";
        /// Relative growth of the drag coefficient with speed, linear in u.
        cd_v1: T = "aero.cd_v1", "cd_v1", NUMBER in "", Range::FINITE,
            "0.12026", "longdrive: fit, docs/validation.md";
        /// Relative growth of the drag coefficient with speed, quadratic in u.
        cd_v2: T = "aero.cd_v2", "cd_v2", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.139425", "longdrive: fit, docs/validation.md";
        /// Height of the saturating part of the lift coefficient.
        cl_hill: T = "aero.cl_hill", "cl_hill", NUMBER in "", Range::FINITE,
            "0.240357", "longdrive: fit, docs/validation.md";
        /// Value of x at which the saturating part of the lift coefficient is half its height.
        cl_half: T = "aero.cl_half", "cl_half", NUMBER in "", Range::above_to(0.0, 100.0),
            "0.0587927", "longdrive: fit, docs/validation.md";
        /// Slope in x of the part of the lift coefficient that does not saturate.
        cl_slope: T = "aero.cl_slope", "cl_slope", NUMBER in "", Range::FINITE,
            "0.625145", "longdrive: fit, docs/validation.md";
        /// Speed at which the lift coefficient is largest.
        cl_speed: T = "aero.cl_speed", "cl_speed", SPEED in "m/s", Range::from_to(-1000.0, 1000.0),
            "41.74701 m/s", "longdrive: fit, docs/validation.md";
        /// Distance from cl_speed at which the lift coefficient is half its maximum.
        cl_width: T = "aero.cl_width", "cl_width", SPEED in "m/s", Range::above_to(0.0, 1000.0),
            "27.33617 m/s", "longdrive: fit, docs/validation.md";
    }

    /// Forces proportional to the speed v, independent of the spin: C_D = cd_speed/v, C_L =
    /// cl_speed/v (smoothed below s = 0.02).
    "macdonald-hanzely": MacdonaldHanzely {
        /// Speed at which the drag coefficient is 1.
        cd_speed: T = "aero.cd_speed", "cd_speed", SPEED in "m/s", Range::from_to(0.0, 1000.0),
            "46 ft/s", "MacDonald & Hanzely (1991), docs/sources.md";
        /// Speed at which the lift coefficient is 1.
        cl_speed: T = "aero.cl_speed", "cl_speed", SPEED in "m/s", Range::from_to(-1000.0, 1000.0),
            "33.4 ft/s", "MacDonald & Hanzely (1991), docs/sources.md";
    }

    /// Fourth-order polynomials in the spin ratio: C_D = cd0 + cd1 s + … + cd4 s⁴, C_L = cl0 + cl1
    /// s + … + cl4 s⁴ (smoothed below s = 0.03; s held above 1.13).
    "naruo-mizota": NaruoMizota {
        /// Drag coefficient without spin.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.2049", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the spin ratio in the drag coefficient.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::FINITE,
            "0.2148", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the squared spin ratio in the drag coefficient.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE,
            "1.098", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the cubed spin ratio in the drag coefficient.
        cd3: T = "aero.cd3", "cd3", NUMBER in "", Range::FINITE,
            "-1.760", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the fourth power of the spin ratio in the drag coefficient.
        cd4: T = "aero.cd4", "cd4", NUMBER in "", Range::FINITE,
            "0.7510", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Lift coefficient extrapolated to no spin.
        cl0: T = "aero.cl0", "cl0", NUMBER in "", Range::FINITE,
            "0.0616", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the spin ratio in the lift coefficient.
        cl1: T = "aero.cl1", "cl1", NUMBER in "", Range::FINITE,
            "1.250", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the squared spin ratio in the lift coefficient.
        cl2: T = "aero.cl2", "cl2", NUMBER in "", Range::FINITE,
            "-1.644", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the cubed spin ratio in the lift coefficient.
        cl3: T = "aero.cl3", "cl3", NUMBER in "", Range::FINITE,
            "1.006", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
        /// Coefficient of the fourth power of the spin ratio in the lift coefficient.
        cl4: T = "aero.cl4", "cl4", NUMBER in "", Range::FINITE,
            "-0.2158", "Naruo, Mizota & Shimozono (2004), docs/sources.md";
    }

    /// With r = Re/10⁵, C_D = cd_s s + cd_low for r < 0.5, cd_s s + cd_high for r > 1, and linear
    /// between (corners rounded over 0.05); C_L = cl_amp s^cl_exp (smoothed below s = 0.001).
    "nathan": Nathan {
        /// Drag coefficient without spin for Re < 5e4.
        cd_low: T = "aero.cd_low", "cd_low", NUMBER in "", Range::from_to(0.0, 100.0),
            "1.9451114", "Nathan (2023), docs/sources.md";
        /// Drag coefficient without spin for Re > 1e5.
        cd_high: T = "aero.cd_high", "cd_high", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.13248", "Nathan (2023), docs/sources.md";
        /// Growth of the drag coefficient with the spin ratio.
        cd_s: T = "aero.cd_s", "cd_s", NUMBER in "", Range::FINITE,
            "0.2087217", "Nathan (2023), docs/sources.md";
        /// Lift coefficient at a spin ratio of 1.
        cl_amp: T = "aero.cl_amp", "cl_amp", NUMBER in "", Range::FINITE,
            "0.2294096", "Nathan (2023), docs/sources.md";
        /// Exponent of the spin ratio in the lift coefficient.
        cl_exp: T = "aero.cl_exp", "cl_exp", NUMBER in "", Range::from_to(0.0, 10.0),
            "0.4", "Nathan (2023), docs/sources.md";
    }

    /// With r = Re/10⁵, C_D changes smoothly from cd_low0 + cd_low1 r + cd_low2 r² to cd_high0 +
    /// cd_high1 r + cd_high2 r² about r = 0.875; C_L = cl1 s + cl2 s² (s held above 0.32).
    "lyu": Lyu {
        /// Drag coefficient below r = 0.875, the part that does not change with the Reynolds
        /// number.
        cd_low0: T = "aero.cd_low0", "cd_low0", NUMBER in "", Range::FINITE,
            "1.50", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of Re/10⁵ in the drag coefficient below r = 0.875.
        cd_low1: T = "aero.cd_low1", "cd_low1", NUMBER in "", Range::FINITE,
            "-2.59", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of (Re/10⁵)² in the drag coefficient below r = 0.875.
        cd_low2: T = "aero.cd_low2", "cd_low2", NUMBER in "", Range::FINITE,
            "1.29", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Drag coefficient above r = 0.875, the part that does not change with the Reynolds
        /// number.
        cd_high0: T = "aero.cd_high0", "cd_high0", NUMBER in "", Range::FINITE,
            "0.56", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of Re/10⁵ in the drag coefficient above r = 0.875.
        cd_high1: T = "aero.cd_high1", "cd_high1", NUMBER in "", Range::FINITE,
            "-0.540", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of (Re/10⁵)² in the drag coefficient above r = 0.875.
        cd_high2: T = "aero.cd_high2", "cd_high2", NUMBER in "", Range::FINITE,
            "0.191", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of the spin ratio in the lift coefficient.
        cl1: T = "aero.cl1", "cl1", NUMBER in "", Range::FINITE,
            "1.99", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
        /// Coefficient of the squared spin ratio in the lift coefficient.
        cl2: T = "aero.cl2", "cl2", NUMBER in "", Range::FINITE,
            "-3.25", "Lyu, Kensrud, Smith & Tosaya (2018), docs/sources.md";
    }

    /// With r = Re/10⁵, C_D = cd0 + cd1 s + cd2 s² + cd_re r, C_L = cl0 + cl1 s + cl2 s² + cl_re/r²
    /// (smoothed below s = 0.042; s held above 0.3, r held below 0.6).
    "usga-itr": UsgaItr {
        /// Drag coefficient without spin, extrapolated to Re = 0.
        cd0: T = "aero.cd0", "cd0", NUMBER in "", Range::from_to(0.0, 100.0),
            "0.2028", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of the spin ratio in the drag coefficient.
        cd1: T = "aero.cd1", "cd1", NUMBER in "", Range::FINITE,
            "-0.2159", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of the squared spin ratio in the drag coefficient.
        cd2: T = "aero.cd2", "cd2", NUMBER in "", Range::FINITE,
            "2.8466", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of Re/10⁵ in the drag coefficient.
        cd_re: T = "aero.cd_re", "cd_re", NUMBER in "", Range::FINITE,
            "0.0165", "US patent 6186002, test ball, docs/sources.md";
        /// Lift coefficient extrapolated to no spin.
        cl0: T = "aero.cl0", "cl0", NUMBER in "", Range::FINITE,
            "0.0860", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of the spin ratio in the lift coefficient.
        cl1: T = "aero.cl1", "cl1", NUMBER in "", Range::FINITE,
            "0.6463", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of the squared spin ratio in the lift coefficient.
        cl2: T = "aero.cl2", "cl2", NUMBER in "", Range::FINITE,
            "1.4789", "US patent 6186002, test ball, docs/sources.md";
        /// Coefficient of 1/(Re/10⁵)² in the lift coefficient.
        cl_re: T = "aero.cl_re", "cl_re", NUMBER in "", Range::FINITE,
            "-0.0122", "US patent 6186002, test ball, docs/sources.md";
    }

    /// Splines D and L through a grid of speeds and spins: C_D = cd_factor D(v, |ω|) and C_L =
    /// cl_factor L(v, |ω|) (13.7 to 88.1 m/s, 2000 to 6000 rpm, held beyond; lift falls to 0 below
    /// 2000 rpm).
    "bearman-harvey": BearmanHarvey {
        /// Factor by which the drag coefficient read from the grid is multiplied.
        cd_factor: T = "aero.cd_factor", "cd_factor", NUMBER in "", Range::from_to(0.0, 100.0),
            "1", "Bearman & Harvey (1976), docs/sources.md";
        /// Factor by which the lift coefficient read from the grid is multiplied.
        cl_factor: T = "aero.cl_factor", "cl_factor", NUMBER in "", Range::FINITE,
            "1", "Bearman & Harvey (1976), docs/sources.md";
    }
}

parameter_struct! {
    /// Factors by which the coefficients of a user's own table are multiplied.
    TableFactors, ParameterGroup::Law, Some(TABLE_LAW), {
        /// Factor by which the drag coefficient of the table is multiplied.
        cd_factor: T = "aero.cd_factor", "cd_factor", NUMBER in "", Range::from_to(0.0, 100.0),
            "1", "your own table, unchanged";
        /// Factor by which the lift coefficient of the table is multiplied.
        cl_factor: T = "aero.cl_factor", "cl_factor", NUMBER in "", Range::FINITE,
            "1", "your own table, unchanged";
    }
}

/// The law of a user's own table (`aero.table`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<T> {
    /// Factors of the drag and lift coefficients.
    pub factors: TableFactors<T>,
    /// The table.
    pub table: &'static LawTable,
}

impl Table<f64> {
    const FORMULA: &'static str = "Splines D and L through your own table (aero.table): C_D = \
                                   cd_factor D and C_L = cl_factor L (held beyond its edges; lift \
                                   falls to 0 below its least spin).";
}

impl<T> Law<T> {
    /// The user's own table, if this law is a table.
    pub fn table(&self) -> Option<&'static LawTable> {
        match self {
            Self::Table(law) => Some(law.table),
            _ => None,
        }
    }
}

impl Law<f64> {
    /// True if both laws have the same name and the same table; their coefficients may differ.
    pub fn is_same(&self, other: &Self) -> bool {
        self.name() == other.name() && self.table() == other.table()
    }
}

impl Default for Law<f64> {
    /// The law `launch-monitor`.
    fn default() -> Self {
        Self::LaunchMonitor(LaunchMonitor::defaults())
    }
}
