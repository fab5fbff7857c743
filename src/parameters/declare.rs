//! The machinery behind the parameter table: what a row is, and the two macros that turn rows into
//! typed fields of a [`Setup`](super::Setup). A parameter is declared once, in `table.rs`;
//! everything else (setup files, `--set`, `--vary`, `--wrt`, JSON keys, listings) walks the rows.

use super::Range;
use crate::units::{Digits, Message, Quantity};
use std::fmt;
use std::hash::{Hash, Hasher};

/// What kind of slot a parameter fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Always has a value.
    Required,
    /// May be unset; its documentation says what then holds.
    Optional,
    /// A setting of the computation, not of the drive: it has no derivative.
    Setting,
}

/// One row of the table: a scalar of the model. The rows are all there are:
/// [`Setup::parameter`](super::Setup::parameter) finds one by its name. Two laws may each have a
/// coefficient of the same name; these are two parameters.
#[derive(Debug)]
#[non_exhaustive]
pub struct Parameter {
    /// Dotted name, as in setup files: `club.loft`.
    pub name: &'static str,
    /// Symbol in `docs/model.md`.
    pub symbol: &'static str,
    /// Kind of quantity, with its SI unit.
    pub quantity: Quantity,
    /// The unit people read it in.
    pub unit: &'static str,
    /// The values it may have.
    pub range: Range,
    /// Its value in the preset `modern-driver`, or for a coefficient of an aerodynamic law the
    /// published one.
    pub default: &'static str,
    /// Where the default comes from.
    pub source: &'static str,
    /// One line of documentation.
    pub doc: &'static str,
    /// Required, optional or a setting.
    pub kind: Kind,
    /// The value, SI, that it counts as where it is unset; `None` where no number says what then
    /// holds.
    pub unset: Option<f64>,
    /// The aerodynamic law it is a coefficient of, if any.
    pub law: Option<&'static str>,
}

impl Parameter {
    /// The default in SI; `None` where the parameter is unset by default.
    pub fn default_value(&self) -> Option<f64> {
        if self.default == UNSET {
            return None;
        }
        // every default is read back in a test
        Some(self.quantity.read(self.default).unwrap_or(f64::NAN))
    }

    /// A message with a value of this parameter after it.
    pub(crate) fn place(&self, message: Message, value: f64) -> Message {
        message.quantity(self.quantity, self.unit, value, Digits::Significant(5))
    }

    /// A value as a person reads it.
    pub fn show(&self, value: Option<f64>) -> String {
        value.map_or_else(
            || UNSET.into(),
            |value| self.quantity.show(value, self.unit),
        )
    }
}

/// Rows are statics: one is equal to itself only.
impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for Parameter {}

/// Of its name and its law, which no other row has.
impl Hash for Parameter {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name, self.law).hash(state);
    }
}

/// Its name.
impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

/// How an optional parameter is unset: `impact.friction = "none"`.
pub const UNSET: &str = "none";

/// Whether a text unsets a parameter.
pub(crate) fn is_unset(text: &str) -> bool {
    [UNSET, "default"].contains(&text.trim())
}

/// A mutable place of a parameter in a setup.
pub(super) enum Slot<'a, T> {
    Required(&'a mut T),
    Optional(&'a mut Option<T>),
    Setting(&'a mut f64),
}

impl Slot<'_, f64> {
    /// What stands there.
    pub fn value(&self) -> Option<f64> {
        match self {
            Self::Required(value) | Self::Setting(value) => Some(**value),
            Self::Optional(value) => **value,
        }
    }
}

/// What the type of a field, `T`, `Option<T>` or `f64`, means for the walks over the rows.
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

/// One struct with a public field per row, and the walks over its rows.
macro_rules! parameter_struct {
    ($(#[doc = $doc:literal])* $Group:ident, $law:expr, {
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
            /// The rows of the table that this struct is made of.
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
                    law: $law,
                } ),+];
                &ROWS
            }

            pub(super) fn defaults() -> Self {
                let [$($field),+] = Self::rows();
                let value = |row: &Parameter| row.default_value().unwrap_or(f64::NAN);
                Self { $( $field: slot!(default $kind value $field), )+ }
            }
        }

        impl<T: Copy> $Group<T> {
            /// The same struct over another number.
            #[inline(always)]
            pub(super) fn map<U>(&self, f: &mut impl FnMut(&'static Parameter, T) -> U) -> $Group<U> {
                let [$($field),+] = $Group::<f64>::rows();
                $Group { $( $field: slot!(map $kind f $field self.$field), )+ }
            }

            /// The place of a parameter, if it is one of this struct.
            fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                let rows = $Group::<f64>::rows();
                // most parameters are of another struct
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

/// The groups of a setup: a struct each, and the `Setup` that holds them all beside the law.
macro_rules! parameter_groups {
    ($( $(#[doc = $doc:literal])* $group:ident : $Group:ident $rows:tt )+) => {
        $( parameter_struct! { $(#[doc = $doc])* $Group, None, $rows } )+

        /// Everything a drive depends on: each parameter of `docs/model.md`, over the number `T`,
        /// and the aerodynamic law with its coefficients.
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
            /// The point of the head whose motion the swing states (`swing.speed_of`).
            pub speed_of: SpeedOf,
        }

        impl Default for Setup<f64> {
            /// The preset `modern-driver`.
            fn default() -> Self {
                // the table's texts are read once: with their units that takes longer than a drive
                static READ: std::sync::LazyLock<Setup<f64>> = std::sync::LazyLock::new(|| {
                    let (law, method) = (Law::default(), Method::default());
                    let (golfer, speed_of) = (Golfer::default(), SpeedOf::default());
                    Setup { $( $group: $Group::defaults(), )+ law, method, golfer, speed_of }
                });
                *READ
            }
        }

        impl<T: Copy> Setup<T> {
            /// The same setup over another number: `f` makes it from each parameter and its value.
            /// Settings and unset parameters stay as they are.
            #[inline(always)]
            pub fn map<U>(&self, mut f: impl FnMut(&'static Parameter, T) -> U) -> Setup<U> {
                let f = &mut f;
                let Self { method, golfer, speed_of, .. } = *self;
                Setup { $( $group: self.$group.map(f), )+ law: self.law.map(f), method, golfer, speed_of }
            }

            /// The parameters that this setup has, in the table's order: all groups, then the
            /// coefficients of its law.
            pub fn parameters(&self) -> Vec<&'static Parameter> {
                let groups = [$( $Group::rows().as_slice(), )+ self.law.rows()];
                groups.into_iter().flatten().collect()
            }

            /// The place of a parameter; none where it belongs to another law.
            #[inline(never)]
            pub(super) fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                $( if let Some(slot) = self.$group.slot(parameter) { return Some(slot); } )+
                self.law.slot(parameter)
            }
        }
    };
}

/// The aerodynamic laws: a struct of coefficients each, and the enum over them.
macro_rules! law_coefficients {
    ($d:tt $( $(#[doc = $doc:literal])* $name:literal : $Law:ident $rows:tt )+) => {
        $( parameter_struct! { $(#[doc = $doc])* $Law, Some($name), $rows } )+

        /// An aerodynamic law with its coefficients. What it says of drag and lift stands in
        /// [`aerodynamics`](crate::aerodynamics), a file per law.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Law<T> {
            $( $(#[doc = $doc])* $Law($Law<T>), )+
            /// Splines through your own table (`aero.table`): C_D = cd_factor D and C_L = cl_factor
            /// L, held beyond its edges, no lift without spin.
            Table(Table<T>),
        }

        impl Law<f64> {
            /// The names of the published laws, as `aero.law` takes them.
            pub const NAMES: &'static [&'static str] = &[$($name),+];

            /// The published law of this name with its coefficients.
            pub fn named(name: &str) -> Option<Self> {
                match name {
                    $( $name => Some(Self::$Law($Law::defaults())), )+
                    _ => None,
                }
            }

            /// The rows of every law, one law after the other.
            pub fn all_rows() -> impl Iterator<Item = &'static Parameter> {
                [$( $Law::rows().as_slice(), )+ Table::rows()].into_iter().flatten()
            }
        }

        impl<T: Copy> Law<T> {
            /// The law's name.
            pub fn name(&self) -> &'static str {
                match self { $( Self::$Law(_) => $name, )+ Self::Table(_) => TABLE_LAW }
            }

            /// What it says of drag and lift.
            pub fn formula(&self) -> &'static str {
                match self { $( Self::$Law(_) => concat!($($doc),*).trim_ascii(), )+ Self::Table(_) => Table::FORMULA }
            }

            #[inline(always)]
            pub(crate) fn map<U>(&self, f: &mut impl FnMut(&'static Parameter, T) -> U) -> Law<U> {
                match self { $( Self::$Law(law) => Law::$Law(law.map(f)), )+ Self::Table(law) => Law::Table(law.map(f)) }
            }

            fn rows(&self) -> &'static [Parameter] {
                match self { $( Self::$Law(_) => $Law::rows(), )+ Self::Table(_) => Table::rows() }
            }

            fn slot(&mut self, parameter: &Parameter) -> Option<Slot<'_, T>> {
                match self { $( Self::$Law(law) => law.slot(parameter), )+ Self::Table(law) => law.factors.slot(parameter) }
            }
        }

        /// Does the same with whichever law it is: `with_law!(law, |l| expression)`.
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
