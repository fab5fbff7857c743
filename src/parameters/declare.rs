//! Macros that turn the rows of the parameter table (`table.rs`) into typed structs. Setup files,
//! settings by name, JSON keys and listings iterate over the rows.
//!
//! The row
//!
//! ```text
//! strike: Strike {
//!     /// Impact point towards the toe.
//!     toe: T = "strike.toe", "r₂", LENGTH in "mm", Range::from_to(-0.2, 0.2), "0 mm", "sweet spot";
//! }
//! ```
//!
//! expands to
//!
//! ```text
//! pub struct Strike<T> { pub toe: T }
//!
//! impl Strike<f64> {
//!     fn rows() -> &'static [Parameter; 1] {
//!         static ROWS: [Parameter; 1] = [Parameter {
//!             name: "strike.toe",
//!             symbol: "r₂",
//!             quantity: Quantity::LENGTH,
//!             unit: "mm",
//!             range: Range::from_to(-0.2, 0.2),
//!             default: "0 mm",
//!             source: "sweet spot",
//!             doc: "Impact point towards the toe.",
//!             kind: Kind::Required,           // Optional for an Option<T>, Setting for an f64
//!             unset: None,                    // Some(0.0) for `or 0.0`
//!             group: ParameterGroup::Strike,
//!             law: None,                      // Some(name) for a coefficient of a law
//!         }];
//!         &ROWS
//!     }
//!     fn defaults() -> Self { let [toe] = Self::rows(); Self { toe: value(toe) } }
//!     fn value(&self, parameter: &Parameter) -> Option<f64> {
//!         if parameter == toe { return Some(self.toe); }
//!         None
//!     }
//! }
//!
//! impl<T: Copy> Strike<T> {
//!     fn map<U>(&self, f) -> Strike<U> { let [toe] = rows(); Strike { toe: f(toe, self.toe) } }
//!     fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
//!         if parameter == toe { return Some(Slot::Required(&mut self.toe)); }
//!         None
//!     }
//! }
//! ```
//!
//! `parameter_struct!` writes this for one struct. `parameter_groups!` calls it for each group and
//! writes [`Setup`](super::Setup), with one field per group; `law_coefficients!` calls it for each
//! law and writes [`Law`](super::Law), with one variant per law. `slot!` selects between the three
//! kinds of fields.

use super::Range;
use crate::units::{Digits, DisplayUnit, Message, Quantity};
use serde::{Serialize, Serializer};
use std::fmt;
use std::hash::{Hash, Hasher};

/// Kind of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Always has a value.
    Required,
    /// May be unset. The documentation of the parameter says what unset means.
    Optional,
    /// A setting of the computation, without derivatives.
    Setting,
}

/// Group of a parameter, with the name of its struct in [`Setup`](super::Setup).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterGroup {
    /// The club just before impact.
    Swing,
    /// The impact point on the face.
    Strike,
    /// The clubhead.
    Club,
    /// The ball.
    Ball,
    /// The contact between club and ball.
    Contact,
    /// Launch conditions.
    LaunchConditions,
    /// The air.
    Air,
    /// Decay of the spin in the air.
    Aero,
    /// The wind.
    Wind,
    /// The ground.
    Ground,
    /// Gravity, and settings of the integration.
    FlightConditions,
    /// Coefficients of an aerodynamic law.
    Law,
}

/// One row of the parameter table: a scalar of the model.
/// [`Setup::parameter`](super::Setup::parameter) finds it by its name. Coefficients of two laws may
/// have the same name; they are two parameters.
#[derive(Debug)]
#[non_exhaustive]
pub struct Parameter {
    /// Dotted name in setup files: `club.loft`.
    pub name: &'static str,
    /// Symbol in `docs/model.md`.
    pub symbol: &'static str,
    /// Kind of quantity, with its SI unit.
    pub quantity: Quantity,
    /// Display unit.
    pub unit: &'static str,
    /// Allowed values.
    pub range: Range,
    /// Value in the preset `modern-driver`; for a coefficient of a law, the published value.
    pub default: &'static str,
    /// Source of the default.
    pub source: &'static str,
    /// One line of documentation.
    pub doc: &'static str,
    /// Required, optional or a setting.
    pub kind: Kind,
    /// SI value that has the same effect as no value (`or 0.0` in the table); `None` if the table
    /// declares no such value.
    pub unset: Option<f64>,
    /// Group of the parameter in a setup.
    pub group: ParameterGroup,
    /// Aerodynamic law of a coefficient; `None` for other parameters.
    pub law: Option<&'static str>,
}

impl Parameter {
    /// The default, SI; `None` if the parameter is unset by default.
    pub fn default_value(&self) -> Option<f64> {
        if self.default == UNSET {
            return None;
        }
        // a test checks that every default can be parsed
        Some(self.quantity.read(self.default).unwrap_or(f64::NAN))
    }

    /// Appends a value of this parameter to a message.
    pub(crate) fn append_value(&self, message: Message, value: f64) -> Message {
        message.quantity(self.quantity, self.unit, value, Digits::Significant(5))
    }

    /// A value as text, in the display unit; [`UNSET`] for `None`.
    pub fn show(&self, value: Option<f64>) -> String {
        value.map_or_else(
            || UNSET.into(),
            |value| self.quantity.show(value, self.unit),
        )
    }
}

/// Parameters are equal if they are the same row, which is a static.
impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for Parameter {}

impl From<&Parameter> for DisplayUnit {
    fn from(parameter: &Parameter) -> Self {
        Self {
            quantity: parameter.quantity,
            unit: parameter.unit,
        }
    }
}

/// Name and law identify a row.
impl Hash for Parameter {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name, self.law).hash(state);
    }
}

/// Writes the name.
impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

/// Writes the name.
impl Serialize for Parameter {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Parameter {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Parameter".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        String::json_schema(generator)
    }
}

/// Text that unsets an optional parameter: `impact.friction = "none"`.
pub const UNSET: &str = "none";

/// True if a text unsets a parameter.
pub(crate) fn is_unset(text: &str) -> bool {
    text.trim() == UNSET
}

/// Mutable reference to the value of a parameter in a setup.
pub(super) enum Slot<'a, T> {
    Required(&'a mut T),
    Optional(&'a mut Option<T>),
    Setting(&'a mut f64),
}

/// Selects the code for a field by its type: `T`, `Option<T>` or `f64`.
macro_rules! slot {
    (kind T) => {
        Kind::Required
    };
    (kind Option) => {
        Kind::Optional
    };
    (kind f64) => {
        Kind::Setting
    };
    (unset) => {
        None
    };
    (unset $value:literal) => {
        Some($value)
    };
    (default T $f:ident $row:ident) => {
        $f($row)
    };
    (default Option $f:ident $row:ident) => {
        $row.default_value().map(|_| $f($row))
    };
    (default f64 $f:ident $row:ident) => {
        $f($row)
    };
    (map T $f:ident $row:ident $value:expr) => {
        $f($row, $value)
    };
    (map Option $f:ident $row:ident $value:expr) => {
        $value.map(|value| $f($row, value))
    };
    (map f64 $f:ident $row:ident $value:expr) => {{
        let _ = $row;
        $value
    }};
    (value T $value:expr) => {
        Some($value)
    };
    (value Option $value:expr) => {
        $value
    };
    (value f64 $value:expr) => {
        Some($value)
    };
    (place T $place:expr) => {
        Slot::Required($place)
    };
    (place Option $place:expr) => {
        Slot::Optional($place)
    };
    (place f64 $place:expr) => {
        Slot::Setting($place)
    };
}

/// A struct with one public field per row, and functions that iterate over its rows.
macro_rules! parameter_struct {
    ($(#[doc = $doc:literal])* $Group:ident, $group:expr, $law:expr, {
        $( $(#[doc = $field_doc:literal])+ $field:ident : $kind:ident $(<$of:ident>)? $(or $unset:literal)? =
            $name:literal, $symbol:literal, $quantity:ident in $unit:literal, $range:expr, $default:literal, $source:literal; )+
    }) => {
        $(#[doc = $doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Group<T> {
            $( $(#[doc = $field_doc])+
               #[doc = concat!("\n\n`", $name, "`, symbol ", $symbol, "; default ", $default, " (", $source, ").")]
               pub $field: $kind $(<$of>)?, )+
        }

        impl $Group<f64> {
            /// The rows of this struct.
            pub(super) fn rows() -> &'static [Parameter; [$(stringify!($field)),+].len()] {
                static ROWS: [Parameter; [$(stringify!($field)),+].len()] = [$( Parameter {
                    name: $name,
                    symbol: $symbol,
                    quantity: Quantity::$quantity,
                    unit: $unit,
                    range: $range,
                    default: $default,
                    source: $source,
                    doc: concat!($($field_doc),+).trim_ascii(),
                    kind: slot!(kind $kind),
                    unset: slot!(unset $($unset)?),
                    group: $group,
                    law: $law,
                } ),+];
                &ROWS
            }

            pub(super) fn defaults() -> Self {
                let [$($field),+] = Self::rows();
                let value = |row: &Parameter| row.default_value().unwrap_or(f64::NAN);
                Self { $( $field: slot!(default $kind value $field), )+ }
            }

            /// The value of a parameter; `None` if it is unset or belongs to another struct.
            fn value(&self, parameter: &Parameter) -> Option<f64> {
                let rows = Self::rows();
                if !rows.as_ptr_range().contains(&std::ptr::from_ref(parameter)) {
                    return None;
                }
                let [$($field),+] = rows;
                $( if parameter == $field { return slot!(value $kind self.$field); } )+
                None
            }
        }

        impl<T: Copy> $Group<T> {
            /// Converts the number type: `f` converts the value of each parameter.
            #[inline(always)]
            pub(super) fn map<U>(&self, f: &mut impl FnMut(&'static Parameter, T) -> U) -> $Group<U> {
                let [$($field),+] = $Group::<f64>::rows();
                $Group { $( $field: slot!(map $kind f $field self.$field), )+ }
            }

            /// Mutable access to the value of a parameter; `None` if it belongs to another struct.
            fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                let rows = $Group::<f64>::rows();
                // most parameters belong to another struct
                if !rows.as_ptr_range().contains(&std::ptr::from_ref(parameter)) {
                    return None;
                }
                let [$($field),+] = rows;
                $( if parameter == $field { return Some(slot!(place $kind &mut self.$field)); } )+
                None
            }
        }
    };
}

/// Declares a struct for each group of a setup, and `Setup` with a field for each group and for the
/// law.
macro_rules! parameter_groups {
    ($( $(#[doc = $doc:literal])* $group:ident : $Group:ident $rows:tt )+) => {
        $( parameter_struct! { $(#[doc = $doc])* $Group, ParameterGroup::$Group, None, $rows } )+

        /// Everything a drive depends on: the parameters of `docs/model.md` over the number type
        /// `T`, and the aerodynamic law with its coefficients.
        ///
        /// ```
        /// use longdrive::Setup;
        /// let mut setup = Setup::preset("mae494").unwrap();
        /// setup.set("club.loft", "10 deg").unwrap();
        /// assert_eq!(setup.club.loft, 10.0_f64.to_radians());
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Setup<T> {
            $( $(#[doc = $doc])* pub $group: $Group<T>, )+
            /// The aerodynamic law (`aero.law`) and its coefficients.
            pub law: Law<T>,
            /// The method of integration (`flight.method`).
            pub method: Method,
            /// The hand of the golfer (`golfer`).
            pub golfer: Golfer,
            /// The point of the head to which speed, attack angle and path of the swing refer
            /// (`swing.speed_of`).
            pub speed_of: SpeedOf,
            /// True if `flight.method` or `flight.step` was stated, by [`set`](Setup::set), a
            /// preset or a file. Otherwise [`StepChoice`](crate::integration::StepChoice) may
            /// choose both, and a setup file written from this setup contains neither. Set this to
            /// true if you assign `method` or `flight.step` directly.
            pub states_step: bool,
        }

        impl Setup<f64> {
            /// The preset `modern-driver`: the values of the parameter table. There is no
            /// `Setup::default`, because commands and setup files start from another preset,
            /// [`DEFAULT_PRESET`](super::presets::DEFAULT_PRESET).
            pub fn modern_driver() -> Self {
                // the texts are parsed once, because that takes longer than a drive
                static TABLE: std::sync::LazyLock<Setup<f64>> = std::sync::LazyLock::new(|| {
                    let (law, method) = (Law::default(), Method::default());
                    let (golfer, speed_of) = (Golfer::default(), SpeedOf::default());
                    Setup {
                        $( $group: $Group::defaults(), )+
                        law,
                        method,
                        golfer,
                        speed_of,
                        states_step: false,
                    }
                });
                *TABLE
            }

            /// The value of a parameter; `None` if it is unset or belongs to another law.
            pub fn value(&self, parameter: &Parameter) -> Option<f64> {
                $( if let Some(value) = self.$group.value(parameter) { return Some(value); } )+
                self.law.value(parameter)
            }

            /// The parameter of this name; `None` for a coefficient of another law.
            pub(super) fn row(&self, name: &str) -> Option<&'static Parameter> {
                let mut groups = [$( $Group::rows().as_slice(), )+ self.law.rows()].into_iter();
                groups.find_map(|rows| rows.iter().find(|row| row.name == name))
            }
        }

        impl<T: Copy> Setup<T> {
            /// Converts the number type: `f` converts the value of each parameter. Settings and
            /// unset parameters are unchanged.
            #[inline(always)]
            pub fn map<U>(&self, mut f: impl FnMut(&'static Parameter, T) -> U) -> Setup<U> {
                let f = &mut f;
                let Self { method, golfer, speed_of, states_step, .. } = *self;
                Setup {
                    $( $group: self.$group.map(f), )+
                    law: self.law.map(f),
                    method,
                    golfer,
                    speed_of,
                    states_step,
                }
            }

            /// The parameters of this setup in the order of the parameter table: all groups, then
            /// the coefficients of its law.
            pub fn parameters(&self) -> Vec<&'static Parameter> {
                let groups = [$( $Group::rows().as_slice(), )+ self.law.rows()];
                groups.into_iter().flatten().collect()
            }

            /// Mutable access to the value of a parameter; `None` for a coefficient of another law.
            #[inline(never)]
            pub(super) fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                $( if let Some(slot) = self.$group.slot(parameter) { return Some(slot); } )+
                self.law.slot(parameter)
            }
        }
    };
}

/// Declares a struct of coefficients for each aerodynamic law, and the enum `Law`.
macro_rules! law_coefficients {
    ($d:tt $( $(#[doc = $doc:literal])* $name:literal : $Law:ident $rows:tt )+) => {
        $( parameter_struct! { $(#[doc = $doc])* $Law, ParameterGroup::Law, Some($name), $rows } )+

        /// An aerodynamic law with its coefficients. The formulas are in
        /// [`aerodynamics`](crate::aerodynamics), one file per law.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Law<T> {
            $( $(#[doc = $doc])* $Law($Law<T>), )+
            /// Splines D and L through your own table (`aero.table`): C_D = cd_factor D and C_L =
            /// cl_factor L. Beyond the edges of the table, D and L are constant. Without spin there
            /// is no lift.
            Table(Table<T>),
        }

        impl Law<f64> {
            /// Names of the published laws, for `aero.law`.
            pub const NAMES: &'static [&'static str] = &[$($name),+];

            /// The published law of this name with its coefficients.
            pub fn named(name: &str) -> Option<Self> {
                match name {
                    $( $name => Some(Self::$Law($Law::defaults())), )+
                    _ => None,
                }
            }

            fn value(&self, parameter: &Parameter) -> Option<f64> {
                match self { $( Self::$Law(law) => law.value(parameter), )+ Self::Table(law) => law.factors.value(parameter) }
            }

            /// The rows of all laws.
            pub fn all_rows() -> impl Iterator<Item = &'static Parameter> {
                [$( $Law::rows().as_slice(), )+ TableFactors::rows()].into_iter().flatten()
            }
        }

        impl<T: Copy> Law<T> {
            /// Name of the law.
            pub fn name(&self) -> &'static str {
                match self { $( Self::$Law(_) => $name, )+ Self::Table(_) => TABLE_LAW }
            }

            /// Formulas of drag and lift, as text.
            pub fn formula(&self) -> &'static str {
                match self { $( Self::$Law(_) => concat!($($doc),*).trim_ascii(), )+ Self::Table(_) => Table::FORMULA }
            }

            #[inline(always)]
            pub(crate) fn map<U>(&self, f: &mut impl FnMut(&'static Parameter, T) -> U) -> Law<U> {
                match self {
                    $( Self::$Law(law) => Law::$Law(law.map(f)), )+
                    Self::Table(law) => Law::Table(Table { factors: law.factors.map(f), table: law.table }),
                }
            }

            fn rows(&self) -> &'static [Parameter] {
                match self { $( Self::$Law(_) => $Law::rows(), )+ Self::Table(_) => TableFactors::rows() }
            }

            fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                match self { $( Self::$Law(law) => law.slot(parameter), )+ Self::Table(law) => law.factors.slot(parameter) }
            }
        }

        /// Evaluates an expression for the law of any variant: `with_law!(law, |l| expression)`.
        macro_rules! with_law {
            ($d law:expr, |$d l:ident| $d body:expr) => {
                match $d law {
                    $( $crate::parameters::Law::$Law($d l) => $d body, )+
                    $crate::parameters::Law::Table($d l) => $d body,
                }
            };
        }
        pub(crate) use with_law;
    };
}
