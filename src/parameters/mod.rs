//! Parameters of a drive: [`Setup`], the table that declares each parameter once, presets with
//! their sources, and setup files.

mod air;
mod choices;
#[macro_use]
mod declare;
mod file;
mod idle;
mod inertia;
mod launch;
mod law_table;
mod lists;
mod number_table;
mod presets;
mod range;
mod setup;
mod steps;
mod table;
mod turf;
mod vary;
mod weights;

pub use air::Alternatives;
#[cfg(feature = "reports")]
pub(crate) use air::is_given_alike;
pub(crate) use air::{
    DEFAULT_TEMPERATURE, LAPSE_RATE, SEA_LEVEL_TEMPERATURE, described_differently, refuse_replaced,
};
#[cfg(feature = "commands")]
pub(crate) use air::{follows_from, is_reset};
pub use choices::{GOLFER, Golfer, METHOD, Method, SPEED_OF, SpeedOf};
#[cfg(feature = "commands")]
pub(crate) use declare::is_unset;
pub use declare::{Kind, Parameter, ParameterGroup, UNSET};
pub use file::SetupFile;
pub(crate) use file::{in_file, place_in};
pub use idle::idle_warnings;
pub use launch::is_of_strike;
pub(crate) use law_table::{CoefficientGrid, DRAG_START, LIFT_START, Surface, bicubic, cells};
pub use law_table::{LawTable, LawTableAxis, LawVariable, TABLE, TABLE_LAW};
#[cfg(feature = "studies")]
pub(crate) use number_table::{NumberTable, TableFault};
pub use presets::{DEFAULT_PRESET, PRESETS, Preset, PresetEntry};
pub use range::Range;
pub(crate) use setup::NO_CLUB;
pub use setup::{CHOICES, SettingText};
pub use steps::is_of_step;
pub(crate) use table::with_law;
pub use table::{
    Aero, Air, Ball, BearmanHarvey, Club, Contact, Ferguson, FlightConditions, Ground, LAW,
    LaunchConditions, LaunchMonitor, Law, Linear, Lyu, MacdonaldHanzely, NaruoMizota, Nathan,
    Robinson, Setup, SmitsSmith, Strike, Swing, Table, TableFactors, UsgaItr, Wind, WinfieldTan,
};
pub use turf::{TURF, TURFS};
pub use vary::Vary;
pub(crate) use weights::Weight;
