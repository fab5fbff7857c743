/// Value of a function, and its exact first and second derivatives by the requested variables, in
/// the order of the variables.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Taylor {
    /// Value.
    pub value: f64,
    /// Gradient ∂/∂xᵢ; empty if only values were requested.
    pub gradient: Vec<f64>,
    /// Hessian ∂²/∂xᵢ∂xⱼ, row by row, symmetric; empty if not requested.
    pub hessian: Vec<Vec<f64>>,
}

impl Taylor {
    /// Zero, with `columns` first derivatives and `rows` rows of the Hessian (0 rows: no Hessian).
    pub(crate) fn zero(columns: usize, rows: usize) -> Self {
        Self {
            value: 0.0,
            gradient: vec![0.0; columns],
            hessian: vec![vec![0.0; columns]; rows],
        }
    }

    /// True if the value and all derivatives are finite.
    pub fn is_finite(&self) -> bool {
        let mut derivatives = self.gradient.iter().chain(self.hessian.iter().flatten());
        self.value.is_finite() && derivatives.all(|d| d.is_finite())
    }

    /// Checks that there are `count` first derivatives, and either `count` × `count` second
    /// derivatives or no second derivatives. `of_what` names the variables in the message.
    ///
    /// # Panics
    /// If the numbers differ; the message names both numbers.
    #[track_caller]
    pub(crate) fn expect_derivatives_by(&self, count: usize, of_what: &str) {
        let (first, rows) = (
            self.gradient.len(),
            self.hessian.iter().map(Vec::len).collect::<Vec<_>>(),
        );
        assert!(
            first == count,
            "there are {count} {of_what}, and {first} derivatives; the numbers must be equal"
        );
        let is_square = rows.is_empty() || rows == vec![count; count];
        assert!(
            is_square,
            "there are {count} {of_what}, and second derivatives in rows of {rows:?}"
        );
    }

    /// The function −f.
    #[must_use]
    pub fn negated(mut self) -> Self {
        self.value = -self.value;
        for d in self
            .gradient
            .iter_mut()
            .chain(self.hessian.iter_mut().flatten())
        {
            *d = -*d;
        }
        self
    }

    /// Weighted sum Σ wₖ fₖ, added in the given order.
    ///
    /// # Panics
    /// If a term has another number of derivatives than the first.
    pub fn sum<'a>(terms: impl IntoIterator<Item = (&'a Self, f64)>) -> Self {
        let mut all: Option<Self> = None;
        for (term, weight) in terms {
            let sum =
                all.get_or_insert_with(|| Self::zero(term.gradient.len(), term.hessian.len()));
            term.expect_derivatives_by(sum.gradient.len(), "derivatives of the first term");
            let [first, this] = [sum.hessian.len(), term.hessian.len()];
            assert!(
                first == this,
                "there are {first} rows of second derivatives of the first term, and {this} of \
                 another"
            );
            sum.value += weight * term.value;
            sum.gradient
                .iter_mut()
                .zip(&term.gradient)
                .for_each(|(sum, d)| *sum += weight * d);
            for (sum, row) in sum.hessian.iter_mut().zip(&term.hessian) {
                sum.iter_mut()
                    .zip(row)
                    .for_each(|(sum, d)| *sum += weight * d);
            }
        }
        all.unwrap_or_default()
    }

    /// Chain rule: g(f) with its derivatives, from g, g′ and g″ at f.
    pub(crate) fn chained(&self, [value, slope, curvature]: [f64; 3]) -> Self {
        let d = &self.gradient;
        let row = |(i, row): (usize, &Vec<f64>)| {
            let entry = |(j, second): (usize, &f64)| slope * second + curvature * d[i] * d[j];
            row.iter().enumerate().map(entry).collect()
        };
        Self {
            value,
            gradient: d.iter().map(|d| slope * d).collect(),
            hessian: self.hessian.iter().enumerate().map(row).collect(),
        }
    }
}
