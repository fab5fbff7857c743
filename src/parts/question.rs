use super::elementary::elementary_functions;
use super::hash::Hash;
use crate::batch::{Batch, Points};
use crate::statistics::Summarized;
use serde::{Deserialize, Serialize};

/// What makes the files of a sweep different from those of another: the same question gives the
/// same bytes of each part. Numbers are written to the last digit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Question {
    /// The version of longdrive.
    pub version: String,
    /// Every parameter of the setup.
    pub setup: String,
    /// Where the points come from.
    pub points: String,
    /// The outcomes, separated by commas.
    pub outcomes: String,
    /// What they are differentiated by; empty for values alone.
    pub derivatives: String,
    /// The largest defect of a drive, m (docs/model.md, eq. 16a); `inf` where the setup's own step
    /// is kept.
    pub largest_defect: String,
    /// The histograms and best rows of each footer.
    pub summary: String,
    /// The processor's architecture and the instructions that are used: `x86_64 avx2`.
    pub instructions: String,
    /// A fingerprint of the C library's sine, cosine, arctangent, exponential and logarithm: other
    /// libraries, and the same on processors for which it has other variants, round otherwise.
    pub functions: String,
    /// Rows of all parts together.
    pub rows: u64,
    /// How many parts there are.
    pub parts: u64,
}

impl Question {
    pub(super) fn new(
        batch: &Batch,
        points: &dyn Points,
        summarized: &Summarized,
        parts: u64,
    ) -> Self {
        let names = |names: Vec<&str>| names.join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            setup: format!("{:?}", batch.setup()),
            points: points.identity(),
            outcomes: names(batch.outcomes().iter().map(|of| of.name()).collect()),
            derivatives: names(batch.wrt().iter().map(|by| by.name).collect()),
            largest_defect: format!("{:?}", batch.largest_defect()),
            summary: summarized.identity(),
            instructions: format!("{} {}", std::env::consts::ARCH, batch.level()),
            functions: format!("{:016x}", elementary_functions()),
            rows: points.rows(),
            parts,
        }
    }

    /// As it is written into each file.
    pub(super) fn text(&self) -> String {
        // strings and whole numbers serialise
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Its SHA-256, in hexadecimal.
    pub fn hash(&self) -> String {
        Hash::of(self.text().as_bytes())
    }

    /// What this question differs in from another, in words; `None` where it does not.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let named = |what: &str, ours: &str, theirs: &str| format!("{what} {ours} and {theirs}");
        if self.version != other.version {
            return Some(named(
                "versions of longdrive",
                &self.version,
                &other.version,
            ));
        }
        if self.instructions != other.instructions {
            return Some(named(
                "instructions",
                &self.instructions,
                &other.instructions,
            ));
        }
        if self.functions != other.functions {
            let what = "C libraries or processors, which round sines and logarithms differently: \
                        functions";
            return Some(named(what, &self.functions, &other.functions));
        }
        if self.parts != other.parts {
            return Some(named(
                "numbers of parts",
                &self.parts.to_string(),
                &other.parts.to_string(),
            ));
        }
        let differ = [
            ("setups", &self.setup, &other.setup),
            ("points", &self.points, &other.points),
            ("outcomes", &self.outcomes, &other.outcomes),
            ("derivatives", &self.derivatives, &other.derivatives),
            ("tolerances", &self.largest_defect, &other.largest_defect),
            ("histograms or best rows", &self.summary, &other.summary),
        ];
        let differ = differ
            .into_iter()
            .filter(|(_, ours, theirs)| ours != theirs)
            .map(|(part, ..)| part);
        let differ: Vec<_> = differ.collect();
        (!differ.is_empty()).then(|| format!("different {}", differ.join(", ")))
    }
}
