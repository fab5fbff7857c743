use crate::batch::{Batch, Points};
use crate::fingerprint::elementary_functions;
use crate::statistics::SummarySpec;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// Definition of a sweep: everything that the bytes of its parts depend on. Numbers are written
/// with all digits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SweepDefinition {
    /// Version of longdrive.
    pub version: String,
    /// All parameters of the setup.
    pub setup: String,
    /// Source of the points.
    pub points: String,
    /// The outcomes, separated by commas.
    pub outcomes: String,
    /// Parameters by which derivatives are computed; empty if there are only values.
    pub derivatives: String,
    /// The largest integration error (defect) of a drive, m (docs/model.md, eq. 16a); `inf` if the
    /// step of the setup is used without a limit of the error.
    pub largest_defect: String,
    /// Description of the histograms and best rows that the footer of each part contains.
    pub summary: String,
    /// Architecture and instruction set of the processor: `x86_64 avx2`.
    pub instructions: String,
    /// Hash of values of the C library's sine, cosine, arctangent, exponential and logarithm, whose
    /// rounding depends on the library and on the processor.
    pub functions: String,
    /// Number of rows of all parts.
    pub rows: u64,
    /// Number of parts.
    pub parts: u64,
}

impl SweepDefinition {
    pub(super) fn new(
        batch: &Batch,
        points: &dyn Points,
        summary_spec: &SummarySpec,
        parts: u64,
    ) -> Self {
        let names = |names: Vec<&str>| names.join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            setup: format!("{:?}", batch.setup()),
            points: points.identity(),
            outcomes: names(batch.outcomes().iter().map(|of| of.name()).collect()),
            derivatives: names(batch.wrt().iter().map(|by| by.name).collect()),
            largest_defect: format!("{:?}", batch.largest_defect),
            summary: summary_spec.identity(),
            instructions: batch.instructions(),
            functions: elementary_functions(),
            rows: points.rows(),
            parts,
        }
    }

    /// JSON for the metadata of each file.
    pub(super) fn text(&self) -> String {
        // serialization cannot fail: the fields are strings and integers
        serde_json::to_string(self).unwrap_or_default()
    }

    /// SHA-256, in hexadecimal.
    pub fn hash(&self) -> String {
        hex(Sha256::new_with_prefix(self.text()))
    }

    /// Difference from another definition, in words; `None` if they are equal.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let functions = "C libraries or processors, which round sines and logarithms differently: \
                         functions";
        let (ours, theirs) = (self.parts.to_string(), other.parts.to_string());
        let named = [
            ("versions of longdrive", &self.version, &other.version),
            ("instructions", &self.instructions, &other.instructions),
            (functions, &self.functions, &other.functions),
            ("numbers of parts", &ours, &theirs),
        ];
        if let Some((what, ours, theirs)) =
            named.into_iter().find(|(_, ours, theirs)| ours != theirs)
        {
            return Some(format!("{what} {ours} and {theirs}"));
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

/// The SHA-256 in hexadecimal, as `sha256sum` prints it.
pub(super) fn hex(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
