use longdrive::optimize::Evaluation;

/// A published problem: minimize f(x) over bounds, with constraint functions between limits.
pub struct Case {
    /// Its name in the collection: `HS71`.
    pub name: &'static str,
    /// The published start.
    pub start: &'static [f64],
    pub low: &'static [f64],
    pub high: &'static [f64],
    /// Limits of the constraint functions; an equality has equal limits.
    pub least: &'static [f64],
    pub most: &'static [f64],
    /// The published optimal value.
    pub optimum: f64,
    /// The printed optimal point; empty without one.
    pub at: &'static [f64],
    /// f and c with exact derivatives.
    pub evaluate: fn(&[f64]) -> Result<Evaluation, String>,
}

/// Declares problems: name, start, bounds, limits, published optimum and point, functions; and a
/// table of them all.
#[macro_export]
macro_rules! problems {
    ($($(#[doc = $doc:literal])* $name:ident {
        start: $start:expr, low: $low:expr, high: $high:expr, least: $least:expr, most: $most:expr,
        optimum: $optimum:expr, at: $at:expr,
        |$x:ident| $body:expr
    })+) => {
        $($(#[doc = $doc])* pub struct $name;
        impl ::longdrive::optimize::Functions for $name {
            fn evaluate<T: ::longdrive::number::Number>(
                &self,
                $x: &[T],
            ) -> Result<::longdrive::optimize::Evaluation<T>, String> {
                let (objective, constraints): (T, Vec<T>) = $body;
                Ok(::longdrive::optimize::Evaluation { objective, constraints })
            }
        })+

        /// Every problem of this file.
        pub fn all() -> Vec<$crate::problems::Case> {
            vec![$($crate::problems::Case {
                name: stringify!($name),
                start: &$start,
                low: &$low,
                high: &$high,
                least: &$least,
                most: &$most,
                optimum: $optimum,
                at: &$at,
                evaluate: |x| ::longdrive::optimize::Problem::evaluate(&::longdrive::optimize::Exact($name), x),
            }),+]
        }
    };
}
