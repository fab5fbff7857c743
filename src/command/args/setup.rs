//! Arguments that give the setup of a drive.

use crate::parameters::DEFAULT_PRESET;

/// Heading of the options of the setup in help texts.
const YOUR_DRIVE: &str = "Your drive";

/// Arguments that state the setup of a drive.
#[derive(Clone, clap::Args)]
pub struct DriveArgs {
    /// A preset's name, a TOML file, or - to read TOML from standard input. A file that names no
    /// preset starts from tour-average.
    #[arg(value_name = "SETUP", default_value = DEFAULT_PRESET)]
    pub setup: String,

    /// Set a parameter, in place of the value of the setup, e.g. club.loft=10.5deg; a quantity with
    /// a dimension needs its unit. Repeatable.
    #[arg(long, value_name = "NAME=VALUE", help_heading = YOUR_DRIVE)]
    pub set: Vec<String>,

    /// Set the club speed (swing.speed), e.g. 95mph.
    #[arg(
        long,
        value_name = "SPEED",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub speed: Option<String>,

    /// Set the attack angle (swing.attack_angle), + up, e.g. -2deg.
    #[arg(
        long,
        value_name = "ANGLE",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub attack: Option<String>,

    /// Set the loft (club.loft), e.g. 10.5deg.
    #[arg(
        long,
        value_name = "ANGLE",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub loft: Option<String>,

    /// Set the temperature of the air (air.temperature), e.g. 50F.
    #[arg(
        long,
        value_name = "TEMPERATURE",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub temperature: Option<String>,

    /// Set the wind speed (wind.speed). The direction is needed too: --set wind.from=0deg for a head
    /// wind.
    #[arg(
        long,
        value_name = "SPEED",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub wind: Option<String>,

    /// Set the altitude (air.altitude), e.g. 5000ft.
    #[arg(
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        help_heading = YOUR_DRIVE
    )]
    pub altitude: Option<String>,

    /// Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
    /// ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
    /// spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
    /// of the setup file.
    #[arg(
        long,
        value_name = "NAME=VALUE,…",
        value_delimiter = ',',
        help_heading = YOUR_DRIVE
    )]
    pub launch: Vec<String>,
}

impl DriveArgs {
    /// The stated short options, such as `--speed`: name of the option, parameter and value.
    pub fn short_names(&self) -> impl Iterator<Item = (&'static str, &'static str, &str)> {
        [
            ("speed", "swing.speed", &self.speed),
            ("attack", "swing.attack_angle", &self.attack),
            ("loft", "club.loft", &self.loft),
            ("temperature", "air.temperature", &self.temperature),
            ("wind", "wind.speed", &self.wind),
            ("altitude", "air.altitude", &self.altitude),
        ]
        .into_iter()
        .filter_map(|(option, parameter, value)| Some((option, parameter, value.as_deref()?)))
    }
}

/// Arguments for the setup, the integration and an answer in JSON.
#[derive(Clone, clap::Args)]
pub struct SetupArgs {
    #[command(flatten)]
    pub drive: DriveArgs,

    /// Choose the cheapest integration method and time step whose error is at most LENGTH (1um if
    /// none is given) in every requested outcome that is a length. The choice is made once, before
    /// the first drive. Commands that compute many drives, such as sweep, optimize and report, do
    /// this with 1um by default, unless the setup or --set gives flight.method or flight.step.
    #[arg(
        long,
        value_name = "LENGTH",
        num_args = 0..=1,
        default_missing_value = "1um",
        require_equals = true,
    )]
    pub tolerance: Option<String>,

    /// Integrate by flight.method and flight.step of the setup, even if the command would choose
    /// others.
    #[arg(long, conflicts_with = "tolerance")]
    pub own_step: bool,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,
}

/// A user's own law, in addition to the published laws.
#[derive(clap::Args)]
pub struct OwnLaw {
    /// Take your own table of drag and lift too, with its factors: aero.table=mine.csv,
    /// aero.cd_factor=1.05. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}
