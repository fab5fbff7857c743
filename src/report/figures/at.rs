use std::fmt;

/// The drive that a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// The drive as set up.
    SetUp,
    /// The drive at the optimum.
    Optimum,
}

/// The text in titles: "as set up", "at the optimum".
impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SetUp => "as set up",
            Self::Optimum => "at the optimum",
        })
    }
}
