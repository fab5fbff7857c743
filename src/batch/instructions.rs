use crate::error::{Error, Result};
use crate::number::Level;
use std::fmt;

/// The instructions of the processor that many drives are computed with. Drives computed with others agree to rounding only; with
/// the same, by the same version of longdrive on the same operating system, to the last bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Instructions {
    /// Those that every processor of the architecture has.
    Baseline,
    /// AVX2 with FMA (x86-64-v3): four numbers in a register.
    Avx2,
    /// AVX-512 (F, DQ, VL) with FMA: eight numbers in a register.
    Avx512,
}

impl Instructions {
    /// All, the fewest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The name on the command line: `avx2`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// The most that this processor has: what is used where nothing else is asked for.
    pub fn here() -> Self {
        Self::of(Level::here())
    }

    pub(super) fn of(level: Level) -> Self {
        match level {
            Level::Baseline => Self::Baseline,
            Level::Four => Self::Avx2,
            Level::Eight => Self::Avx512,
        }
    }

    pub(super) fn level(self) -> Level {
        match self {
            Self::Baseline => Level::Baseline,
            Self::Avx2 => Level::Four,
            Self::Avx512 => Level::Eight,
        }
    }

    /// The same, where this processor has them.
    pub(super) fn checked(self) -> Result<Self> {
        let most = Self::here();
        if self <= most {
            return Ok(self);
        }
        let reason = format!(
            "this processor does not have them; the most it has is {most}. Take --instructions {most} on every machine, or a machine that has {self}"
        );
        Err(Error::Together { given: format!("the instructions {self}"), reason })
    }
}

impl fmt::Display for Instructions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
