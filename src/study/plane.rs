use super::Vary;
use crate::batch::{Batch, CHUNK};
use crate::derivative::Order;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Setup;
use rayon::prelude::*;

/// Outcomes at the nodes of a grid over two parameters, computed as a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Parameter of the horizontal axis.
    pub across: Vary,
    /// Parameter of the vertical axis.
    pub up: Vary,
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Each outcome at each node, SI, row by row from the lowest row; `None` if the drive does not
    /// have the outcome.
    pub values: Vec<Vec<Option<f64>>>,
    /// Derivatives of each outcome by the two parameters at each node, SI, in the order of
    /// `values`; `None` if they do not exist. Empty if only values were computed.
    pub gradients: Vec<Vec<Option<[f64; 2]>>>,
}

impl Plane {
    /// Flies a setup with the parameters `across` and `up` at the nodes of a grid. Gradients are
    /// computed unless `order` is [`Order::Value`]. The setup need not have values of the two
    /// parameters.
    ///
    /// # Errors
    /// The errors of [`Batch::new`].
    pub fn fly(
        setup: &Setup<f64>,
        of: &[Outcome],
        across: Vary,
        up: Vary,
        [columns, rows]: [usize; 2],
        order: Order,
    ) -> Result<Self> {
        let both = [across.parameter, up.parameter];
        let wrt = match order {
            Order::Value => &[][..],
            Order::First | Order::Second => &both,
        };
        let batch = Batch::new(setup, &both, of, wrt)?;
        let mut plane = Self {
            across,
            up,
            columns,
            rows,
            values: vec![],
            gradients: vec![],
        };
        let places: Vec<[f64; 2]> = (0..columns * rows).map(|node| plane.node(node)).collect();
        let blocks: Vec<_> = places
            .par_chunks(CHUNK)
            .map(|chunk| batch.evaluate(0, chunk.concat()))
            .collect();
        let column = |i: usize| blocks.iter().flat_map(move |block| block.result(i));
        plane.values = (0..of.len()).map(|i| column(i).collect()).collect();
        let gradients = |i: usize| {
            let [across, up] = [0, 1].map(|axis| column(of.len() + 2 * i + axis));
            across.zip(up).map(|(a, b)| Some([a?, b?])).collect()
        };
        if !wrt.is_empty() {
            plane.gradients = (0..of.len()).map(gradients).collect();
        }
        Ok(plane)
    }

    /// Position of a node, SI: across, up.
    pub fn node(&self, node: usize) -> [f64; 2] {
        let part = |at: usize, count: usize| at as f64 / (count.max(2) - 1) as f64;
        let along = |vary: &Vary, part: f64| vary.low + part * (vary.high - vary.low);
        [
            along(&self.across, part(node % self.columns, self.columns)),
            along(&self.up, part(node / self.columns, self.rows)),
        ]
    }

    /// The largest value of the outcome with index `of` over the nodes at positions that `may`
    /// allows. Returns the position of the node, SI, and the value; `None` if no allowed node has a
    /// value.
    pub fn largest(&self, of: usize, may: impl Fn([f64; 2]) -> bool) -> Option<([f64; 2], f64)> {
        let values = self.values.get(of)?.iter().enumerate();
        let known = values
            .filter_map(|(node, value)| Some((self.node(node), (*value)?)))
            .filter(|(at, _)| may(*at));
        known.max_by(|a, b| a.1.total_cmp(&b.1))
    }
}
