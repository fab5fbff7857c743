//! The dual active-set method of Goldfarb & Idnani (1983), for strictly convex programs: from the unconstrained minimum, the
//! most violated constraint is added again and again, and what then pulls the wrong way is dropped. It needs no tolerance to
//! tell active from inactive, and it proves infeasibility. The factors of what is active are updated by plane rotations, so
//! that a change of the active set costs the square of the number of variables.

use super::active_set::{ActiveSet, Holder};
use super::program::{End, QuadraticProgram};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// What the method says of a program.
pub(super) enum Dual {
    /// What holds the minimum.
    Active(ActiveSet),
    /// The rows cannot be met within the ends.
    Infeasible,
    /// It cannot begin, or did not end.
    Undecided,
}

/// Curvature given to the pieces' common value, which has none of its own.
const LEVEL_CURVATURE: f64 = 1e-7;
/// Constraints are held to this part of the largest step, in units of their normal's length …
const TOLERANCE: f64 = 1e-11;
/// … and to the rounding of their limits.
const ROUNDING: f64 = 1e-14;
/// Where less than this part of a normal points away from those of the active constraints, it depends on them.
const DEPENDENT: f64 = 1e-10;

impl QuadraticProgram {
    /// The active set by the dual method. A program without curvature is undecided: there is no unconstrained minimum to begin at,
    /// and of several sets of multipliers those in the middle, which an interior point finds, serve a search best.
    pub(super) fn dual_active_set(&self) -> Dual {
        let all = self.constraints();
        let walk = self.objective().and_then(|(hessian, slope)| Walk::from_minimum(&all, &hessian, &slope));
        let Some(mut walk) = walk else { return Dual::Undecided };
        for _ in 0..20 * (all.limits.len() + 1) {
            let Some(added) = walk.most_violated() else {
                return Dual::Active(self.held_by(walk.active.iter().map(|&k| all.holders[k])));
            };
            if !walk.hold(added) {
                return Dual::Infeasible;
            }
        }
        Dual::Undecided
    }

    /// The factors of the curvature, if there is any, and the slope in d, and in the pieces' common value where there are several.
    fn objective(&self) -> Option<(Cholesky<f64, Dyn>, DVector<f64>)> {
        let n = self.dimension();
        if !self.curvature.amax().is_normal() {
            return None;
        }
        let (hessian, slope) = if self.pieces.len() == 1 {
            (self.curvature.clone(), self.pieces[0].gradient.clone())
        } else {
            let mut hessian = self.curvature.clone().resize(n + 1, n + 1, 0.0);
            hessian[(n, n)] = LEVEL_CURVATURE;
            (hessian, DVector::from_fn(n + 1, |i, _| f64::from(i == n)))
        };
        Some((Cholesky::new(hessian)?, slope))
    }

    fn constraints(&self) -> Constraints {
        let (n, has_level) = (self.dimension(), self.pieces.len() > 1);
        let size = n + usize::from(has_level);
        let dense = 2 * self.rows.len() + self.pieces.len();
        let mut all = Constraints::with_capacity(size, dense, 2 * n + dense);
        let sides = |low: f64, high: f64| {
            [(1.0, low, End::Low), (-1.0, -high, End::High)].into_iter().take(if low == high { 1 } else { 2 })
        };
        for i in 0..n {
            for (sign, limit, end) in sides(self.low[i], self.high[i]) {
                all.add_end(i, sign, limit, self.low[i] == self.high[i], end);
            }
        }
        for (j, row) in self.rows.iter().enumerate() {
            for (sign, limit, end) in sides(row.low, row.high).filter(|(_, limit, _)| limit.is_finite()) {
                let normal = all.add(limit, row.low == row.high, Holder::Row(j, end));
                normal.iter_mut().zip(&row.normal).for_each(|(to, from)| *to = sign * from);
            }
        }
        for (k, piece) in self.pieces.iter().enumerate().filter(|_| has_level) {
            // t − gradient · d ≥ offset
            let normal = all.add(piece.offset, false, Holder::Piece(k));
            normal.iter_mut().zip(&piece.gradient).for_each(|(to, from)| *to = -from);
            normal[n] = 1.0;
        }
        all
    }
}

/// normal · x ≥ limit, or = for an equation.
struct Constraints {
    size: usize,
    /// Those that are not of one variable alone, one after the other.
    dense: Vec<f64>,
    normals: Vec<Normal>,
    limits: Vec<f64>,
    are_equations: Vec<bool>,
    holders: Vec<Holder>,
}

#[derive(Clone, Copy)]
enum Normal {
    /// A sign on the axis of a variable.
    Axis(usize, f64),
    /// So many come before it.
    Dense(usize),
}

impl Constraints {
    fn with_capacity(size: usize, dense: usize, count: usize) -> Self {
        Self {
            size,
            dense: Vec::with_capacity(size * dense),
            normals: Vec::with_capacity(count),
            limits: Vec::with_capacity(count),
            are_equations: Vec::with_capacity(count),
            holders: Vec::with_capacity(count),
        }
    }

    /// Adds one, and hands out its normal of zeros.
    fn add(&mut self, limit: f64, is_equation: bool, holder: Holder) -> &mut [f64] {
        let before = self.dense.len();
        self.push(Normal::Dense(before / self.size), limit, is_equation, holder);
        self.dense.resize(before + self.size, 0.0);
        &mut self.dense[before..]
    }

    /// Adds the end of a variable.
    fn add_end(&mut self, i: usize, sign: f64, limit: f64, is_equation: bool, end: End) {
        self.push(Normal::Axis(i, sign), limit, is_equation, Holder::Variable(i, end));
    }

    fn push(&mut self, normal: Normal, limit: f64, is_equation: bool, holder: Holder) {
        self.normals.push(normal);
        self.limits.push(limit);
        self.are_equations.push(is_equation);
        self.holders.push(holder);
    }

    fn row(&self, at: usize) -> &[f64] {
        &self.dense[at * self.size..(at + 1) * self.size]
    }

    /// normal · x.
    fn value(&self, k: usize, x: &[f64]) -> f64 {
        match self.normals[k] {
            Normal::Axis(i, sign) => sign * x[i],
            Normal::Dense(at) => dot(self.row(at), x),
        }
    }

    fn length(&self, k: usize) -> f64 {
        match self.normals[k] {
            Normal::Axis(..) => 1.0,
            Normal::Dense(at) => dot(self.row(at), self.row(at)).sqrt().max(f64::MIN_POSITIVE),
        }
    }

    /// Jᵀ normal.
    fn turned(&self, k: usize, j: &DMatrix<f64>) -> DVector<f64> {
        match self.normals[k] {
            Normal::Axis(i, sign) => DVector::from_fn(j.ncols(), |column, _| sign * j[(i, column)]),
            Normal::Dense(at) => j.tr_mul(&DVector::from_column_slice(self.row(at))),
        }
    }
}

/// Where the method is: x, what holds it there, and the factors of that: JᵀBJ = 1 and JᵀN = R, upper triangular, with the
/// normals of what is active as N.
struct Walk<'a> {
    all: &'a Constraints,
    x: DVector<f64>,
    j: DMatrix<f64>,
    r: DMatrix<f64>,
    active: Vec<usize>,
    multipliers: Vec<f64>,
    /// 1, or −1 for an equation that was missed from above and turned round.
    signs: Vec<f64>,
    is_active: Vec<bool>,
    lengths: Vec<f64>,
}

impl<'a> Walk<'a> {
    /// Begins at the unconstrained minimum.
    fn from_minimum(all: &'a Constraints, hessian: &Cholesky<f64, Dyn>, slope: &DVector<f64>) -> Option<Self> {
        let n = all.size;
        let mut j = DMatrix::identity(n, n);
        if !hessian.l_dirty().tr_solve_lower_triangular_mut(&mut j) {
            return None;
        }
        let x = -(&j * j.tr_mul(slope));
        let count = all.limits.len();
        x.iter().all(|x| x.is_finite()).then(|| Self {
            all,
            x,
            j,
            r: DMatrix::zeros(n, n),
            active: Vec::with_capacity(n),
            multipliers: Vec::with_capacity(n),
            signs: vec![1.0; count],
            is_active: vec![false; count],
            lengths: (0..count).map(|k| all.length(k)).collect(),
        })
    }

    fn slack(&self, k: usize) -> f64 {
        self.signs[k] * (self.all.value(k, self.x.as_slice()) - self.all.limits[k])
    }

    /// The constraint that is missed by most, equations before the others; an equation that is missed from above is turned round.
    fn most_violated(&mut self) -> Option<usize> {
        let tolerance = TOLERANCE * self.x.amax() + ROUNDING;
        let mut worst: Option<(bool, f64, usize)> = None;
        for k in (0..self.all.limits.len()).filter(|&k| !self.is_active[k]) {
            let (slack, is_equation, length) = (self.slack(k), self.all.are_equations[k], self.lengths[k]);
            let missed = if is_equation { slack.abs() } else { -slack };
            let rank = (is_equation, missed / length);
            let is_missed = missed > tolerance * length;
            if is_missed && worst.is_none_or(|(before, most, _)| rank > (before, most)) {
                worst = Some((rank.0, rank.1, k));
            }
        }
        let (is_equation, _, k) = worst?;
        if is_equation && self.slack(k) > 0.0 {
            self.signs[k] = -self.signs[k];
        }
        Some(k)
    }

    /// Moves to where a constraint holds too, dropping what pulls the wrong way then; `false` where it cannot be met.
    fn hold(&mut self, added: usize) -> bool {
        let n = self.x.len();
        let mut weight = 0.0;
        loop {
            let q = self.active.len();
            let mut d = self.all.turned(added, &self.j) * self.signs[added];
            let size = d.norm_squared();
            let curvature = d.rows(q, n - q).norm_squared();
            // what the active multipliers lose for a unit of the added one's
            let mut lost = d.rows(0, q).into_owned();
            self.r.view((0, 0), (q, q)).solve_upper_triangular_mut(&mut lost);
            let is_dependent = curvature <= DEPENDENT * DEPENDENT * size;
            let blocking = (0..q)
                .filter(|&at| !self.all.are_equations[self.active[at]] && lost[at] > 0.0)
                .map(|at| (self.multipliers[at] / lost[at], at))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let full = if is_dependent { f64::INFINITY } else { -self.slack(added) / curvature };
            let step = full.min(blocking.map_or(f64::INFINITY, |(step, _)| step));
            if !step.is_finite() {
                return false;
            }
            self.multipliers.iter_mut().zip(&lost).for_each(|(multiplier, lost)| *multiplier -= step * lost);
            weight += step;
            if !is_dependent {
                self.x.gemv(step, &self.j.columns(q, n - q), &d.rows(q, n - q), 1.0);
            }
            if step == full {
                self.add(added, weight, &mut d);
                return true;
            }
            if let Some((_, at)) = blocking {
                self.drop(at);
            }
        }
    }

    /// Adds a constraint to what is active: rotations of the last columns of J leave of Jᵀ normal what R has room for.
    fn add(&mut self, added: usize, weight: f64, d: &mut DVector<f64>) {
        let q = self.active.len();
        for k in (q + 1..d.len()).rev() {
            let Some(rotation) = Rotation::of(d[k - 1], d[k]) else { continue };
            (d[k - 1], d[k]) = (rotation.length, 0.0);
            rotation.turn_columns(&mut self.j, k - 1);
        }
        self.r.view_mut((0, q), (q + 1, 1)).copy_from(&d.rows(0, q + 1));
        self.active.push(added);
        self.multipliers.push(weight);
        self.is_active[added] = true;
    }

    /// Drops one of the active constraints: the columns of R behind it move up, and rotations make it triangular again.
    fn drop(&mut self, at: usize) {
        let q = self.active.len();
        self.is_active[self.active[at]] = false;
        self.active.remove(at);
        self.multipliers.remove(at);
        for column in at..q - 1 {
            for row in 0..=column + 1 {
                self.r[(row, column)] = self.r[(row, column + 1)];
            }
            let Some(rotation) = Rotation::of(self.r[(column, column)], self.r[(column + 1, column)]) else { continue };
            (self.r[(column, column)], self.r[(column + 1, column)]) = (rotation.length, 0.0);
            for later in column + 2..q {
                let (upper, lower) = (self.r[(column, later)], self.r[(column + 1, later)]);
                (self.r[(column, later)], self.r[(column + 1, later)]) = rotation.turned(upper, lower);
            }
            rotation.turn_columns(&mut self.j, column);
        }
    }
}

/// The rotation of a plane that turns a vector into its first axis.
struct Rotation {
    cosine: f64,
    sine: f64,
    length: f64,
}

impl Rotation {
    /// `None` where the vector lies there already.
    fn of(first: f64, second: f64) -> Option<Self> {
        let length = first.hypot(second);
        (second != 0.0).then(|| Self { cosine: first / length, sine: second / length, length })
    }

    fn turned(&self, first: f64, second: f64) -> (f64, f64) {
        (self.cosine * first + self.sine * second, self.cosine * second - self.sine * first)
    }

    /// Turns two columns that lie beside each other.
    fn turn_columns(&self, matrix: &mut DMatrix<f64>, first: usize) {
        let n = matrix.nrows();
        let (left, right) = matrix.as_mut_slice()[first * n..(first + 2) * n].split_at_mut(n);
        for (left, right) in left.iter_mut().zip(right) {
            (*left, *right) = self.turned(*left, *right);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
