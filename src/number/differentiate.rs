//! The passes of a differentiation: how many variables are seeded at once, over which number, and where what comes
//! back goes.

use super::{Jet, Jet2, Seeded, Taylor};
use num_dual::{Dual2_64, Dual64};

/// How far a differentiation goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Values.
    Value,
    /// Values and gradients.
    First,
    /// Values, gradients and Hessians.
    Second,
}

/// Which second derivatives are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pairs {
    /// All of them.
    All,
    /// Those that the last variable takes part in.
    WithLast,
}

/// Something with outputs that depend on variables which can be seeded.
pub(crate) trait Seedable {
    /// Why there is no output.
    type Error;

    /// The outputs, where variable `seeds[k]` is the independent variable of direction k and all others are constant.
    fn outputs<D: Seeded>(&self, seeds: &[usize]) -> Result<Vec<D>, Self::Error>;
}

/// Variables differentiated by in one pass of a gradient: wider is cheaper for each, as far as measured.
const GRADIENT_WIDTH: usize = 12;

/// Each output of `f` with its gradient by `n` variables; `progress` is told how many passes of how many are done.
pub(crate) fn first<F: Seedable>(
    f: &F,
    n: usize,
    mut progress: impl FnMut(usize, usize),
) -> Result<Vec<Taylor>, F::Error> {
    let mut taylors = vec![];
    let places: Vec<usize> = (0..n).collect();
    let chunks = places.chunks(GRADIENT_WIDTH);
    let passes = chunks.len();
    for (done, chunk) in chunks.enumerate() {
        match chunk.len() {
            1 => pass::<Dual64, F>(f, n, chunk, Order::First, &mut taylors)?,
            2 => pass::<Jet<2>, F>(f, n, chunk, Order::First, &mut taylors)?,
            3..=4 => pass::<Jet<4>, F>(f, n, chunk, Order::First, &mut taylors)?,
            _ => pass::<Jet<GRADIENT_WIDTH>, F>(f, n, chunk, Order::First, &mut taylors)?,
        }
        progress(done + 1, passes);
    }
    Ok(taylors)
}

/// Each output of `f` with its gradient and the wanted part of its Hessian by `n` variables; `progress` as in [`first`].
pub(crate) fn second<F: Seedable>(
    f: &F,
    n: usize,
    pairs: Pairs,
    mut progress: impl FnMut(usize, usize),
) -> Result<Vec<Taylor>, F::Error> {
    let mut taylors = vec![];
    if n == 1 {
        pass::<Dual2_64, F>(f, n, &[0], Order::Second, &mut taylors)?;
        progress(1, 1);
        return Ok(taylors);
    }
    // a pass for each pair: wider second-order jets cost more for each entry
    let is_wanted = |i: &usize| pairs == Pairs::All || i + 1 == n;
    let wanted: Vec<[usize; 2]> = (0..n).filter(is_wanted).flat_map(|i| (0..i).map(move |j| [j, i])).collect();
    for (done, pair) in wanted.iter().enumerate() {
        pass::<Jet2<2, 3>, F>(f, n, pair, Order::Second, &mut taylors)?;
        progress(done + 1, wanted.len());
    }
    Ok(taylors)
}

/// One run over `D` with the variables at `seeds`; what it tells goes to the same places of `taylors`.
#[inline(never)]
fn pass<D: Seeded, F: Seedable>(
    f: &F,
    n: usize,
    seeds: &[usize],
    order: Order,
    taylors: &mut Vec<Taylor>,
) -> Result<(), F::Error> {
    let outputs = f.outputs::<D>(seeds)?;
    if taylors.is_empty() {
        let columns = if order >= Order::First { n } else { 0 };
        let rows = if order == Order::Second { n } else { 0 };
        let zero = Taylor { value: 0.0, gradient: vec![0.0; columns], hessian: vec![vec![0.0; columns]; rows] };
        taylors.resize(outputs.len(), zero);
    }
    for (output, taylor) in outputs.iter().zip(taylors) {
        taylor.value = output.re();
        for (i, &row) in seeds.iter().enumerate() {
            taylor.gradient[row] = output.first(i);
            if let Some(hessian_row) = taylor.hessian.get_mut(row) {
                for (j, &column) in seeds.iter().enumerate() {
                    hessian_row[column] = output.second(i, j);
                }
            }
        }
    }
    Ok(())
}
