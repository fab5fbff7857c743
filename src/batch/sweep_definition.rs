use super::definition::Batch;
use super::points::Points;
use crate::fingerprint::elementary_functions;
use serde::{Deserialize, Serialize};

/// Definition of a sweep: everything that its rows and the bytes of its parts depend on. Numbers
/// are written with all digits.
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
    /// Description of the histograms and best rows that the footer of each part contains; empty if
    /// there are none.
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
    /// The definition of the sweep of `batch` over `points`. `summary` describes the histograms and
    /// best rows.
    pub(crate) fn new(batch: &Batch, points: &dyn Points, summary: String, parts: u64) -> Self {
        let names = |names: Vec<&str>| names.join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            setup: format!("{:?}", batch.setup()),
            points: points.identity(),
            outcomes: names(batch.outcomes().iter().map(|of| of.name()).collect()),
            derivatives: names(batch.wrt().iter().map(|by| by.name).collect()),
            largest_defect: format!("{:?}", batch.largest_defect),
            summary,
            instructions: batch.instructions(),
            functions: elementary_functions(),
            rows: points.rows(),
            parts,
        }
    }

    /// JSON for the metadata of a Parquet file: a part, or a whole sweep.
    #[cfg(feature = "parquet")]
    pub(crate) fn text(&self) -> String {
        // serialization cannot fail: the fields are strings and integers
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Difference from another definition, in words; `None` if they are equal. Setup and tolerance
    /// are compared last: the integration step in the setup and the largest defect depend on
    /// everything else.
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
        let options = [
            ("points", &self.points, &other.points),
            ("outcomes", &self.outcomes, &other.outcomes),
            ("derivatives", &self.derivatives, &other.derivatives),
            ("histograms or best rows", &self.summary, &other.summary),
        ];
        let differ = options
            .into_iter()
            .filter(|(_, ours, theirs)| ours != theirs)
            .map(|(part, ..)| part);
        let differ: Vec<_> = differ.collect();
        if !differ.is_empty() {
            return Some(format!("different {}", differ.join(", ")));
        }
        let is_other_setup = self.setup != other.setup;
        let is_other_tolerance = self.largest_defect != other.largest_defect;
        let what = match (is_other_setup, is_other_tolerance) {
            (true, true) => "setups or tolerances",
            (true, false) => "setups",
            (false, true) => "tolerances",
            (false, false) => return None,
        };
        Some(format!("different {what}"))
    }
}
