//! The walk of the dual active-set method, with its factors.

use super::polish::Candidate;
use nalgebra::{DMatrix, DVector};

/// Constraints are held to this part of the largest step, in units of their normal's length …
const TOLERANCE: f64 = 1e-11;
/// … and to the rounding of their limits.
const ROUNDING: f64 = 1e-14;
/// A minimum that meets its equations to this part of the size of their terms is exact …
const ACCURATE: f64 = 1e-14;
/// … after so many refinements at most.
const REFINEMENTS: usize = 2;
/// Where less than this part of a normal points away from those of the active constraints, it depends on them.
const DEPENDENT: f64 = 1e-10;

/// low ≤ normal · x ≤ high; an equation where both are one number.
pub(super) struct Constraints {
    pub size: usize,
    /// The first constraints are the limits of so many variables.
    pub variables: usize,
    /// The normals of the others, one after the other.
    pub dense: Vec<f64>,
    pub limits: Vec<(f64, f64)>,
    /// Of the normals.
    pub lengths: Vec<f64>,
}

impl Constraints {
    /// The normal of a constraint that is not the limit of one variable.
    fn normal(&self, k: usize) -> &[f64] {
        let at = (k - self.variables) * self.size;
        &self.dense[at..at + self.size]
    }

    /// normal · x.
    fn value(&self, k: usize, x: &[f64]) -> f64 {
        if k < self.variables { x[k] } else { dot(self.normal(k), x) }
    }

    /// Where a constraint holds.
    fn limit(&self, held: &Held) -> f64 {
        let (low, high) = self.limits[held.constraint];
        if held.sign > 0.0 { low } else { high }
    }

    fn is_equation(&self, k: usize) -> bool {
        self.limits[k].0 == self.limits[k].1
    }
}

/// A constraint that holds x: at its lower limit with the sign 1, at its upper with −1.
pub(super) struct Held {
    pub constraint: usize,
    pub sign: f64,
    multiplier: f64,
}

/// Where the method is: x, what holds it there, and the factors of that: JᵀBJ = 1 and JᵀN = R, upper triangular, with the
/// normals of what is active, times their signs, as N.
pub(super) struct Walk<'a> {
    all: &'a Constraints,
    x: DVector<f64>,
    j: DMatrix<f64>,
    r: DMatrix<f64>,
    pub active: Vec<Held>,
    is_active: Vec<bool>,
    /// Jᵀ normal of what is added.
    turned: Vec<f64>,
    /// What the active multipliers lose for a unit of the added one's.
    lost: Vec<f64>,
}

impl<'a> Walk<'a> {
    /// Begins at the unconstrained minimum.
    pub fn from_minimum(all: &'a Constraints, factors: &DMatrix<f64>, slope: &DVector<f64>) -> Option<Self> {
        let n = all.size;
        // J is the inverse of the upper triangular factor Lᵀ
        let mut j = DMatrix::zeros(n, n);
        let mut x = DVector::zeros(n);
        for (c, column) in j.as_mut_slice().chunks_exact_mut(n).enumerate() {
            column[c] = factors[(c, c)].recip();
            for i in (0..c).rev() {
                let below = &factors.as_slice()[i * n..][..=c];
                column[i] = -dot(&below[i + 1..], &column[i + 1..=c]) / below[i];
            }
            let way = dot(&column[..=c], &slope.as_slice()[..=c]);
            add_times(x.as_mut_slice(), -way, column);
        }
        x.iter().all(|x| x.is_finite()).then(|| Self {
            all,
            x,
            j,
            r: DMatrix::zeros(n, n),
            active: Vec::with_capacity(n),
            is_active: vec![false; all.limits.len()],
            turned: Vec::with_capacity(n),
            lost: Vec::with_capacity(n),
        })
    }

    /// The constraint that is missed by most, equations before the others; and its sign.
    pub fn most_violated(&self) -> Option<(usize, f64)> {
        let tolerance = TOLERANCE * self.x.amax() + ROUNDING;
        let mut worst: Option<((bool, f64), usize, f64)> = None;
        for (k, &(low, high)) in self.all.limits.iter().enumerate().filter(|(k, _)| !self.is_active[*k]) {
            let (value, length) = (self.all.value(k, self.x.as_slice()), self.all.lengths[k]);
            let (missed, sign) = if low - value >= value - high { (low - value, 1.0) } else { (value - high, -1.0) };
            if missed > tolerance * length {
                let rank = (low == high, missed / length);
                if worst.is_none_or(|(most, ..)| rank > most) {
                    worst = Some((rank, k, sign));
                }
            }
        }
        worst.map(|(_, k, sign)| (k, sign))
    }

    /// Moves to where a constraint holds too, dropping what pulls the wrong way then; `false` where it cannot be met.
    pub fn hold(&mut self, added: usize, sign: f64) -> bool {
        let n = self.x.len();
        let mut held = Held { constraint: added, sign, multiplier: 0.0 };
        loop {
            let q = self.active.len();
            self.turn(&held);
            let size = dot(&self.turned, &self.turned);
            let curvature = dot(&self.turned[q..], &self.turned[q..]);
            let is_dependent = curvature <= DEPENDENT * DEPENDENT * size;
            let blocking = self.active.iter().zip(&self.lost).enumerate();
            let blocking = blocking
                .filter(|(_, (held, lost))| **lost > 0.0 && !self.all.is_equation(held.constraint))
                .map(|(at, (held, lost))| (held.multiplier / lost, at))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let missed = sign * (self.all.limit(&held) - self.all.value(added, self.x.as_slice()));
            let full = if is_dependent { f64::INFINITY } else { missed / curvature };
            let step = full.min(blocking.map_or(f64::INFINITY, |(step, _)| step));
            if !step.is_finite() {
                return false;
            }
            self.active.iter_mut().zip(&self.lost).for_each(|(held, lost)| held.multiplier -= step * lost);
            held.multiplier += step;
            if !is_dependent {
                let columns = self.j.as_slice().chunks_exact(n).zip(&self.turned).skip(q);
                columns.for_each(|(column, d)| add_times(self.x.as_mut_slice(), step * d, column));
            }
            if step == full {
                self.add(held);
                return true;
            }
            if let Some((_, at)) = blocking {
                self.drop(at);
            }
        }
    }

    /// Turns the normal of a constraint by J, and finds what the active multipliers lose for it.
    fn turn(&mut self, &Held { constraint, sign, .. }: &Held) {
        let (n, q, all) = (self.x.len(), self.active.len(), self.all);
        let columns = self.j.as_slice().chunks_exact(n);
        self.turned.clear();
        if constraint < all.variables {
            self.turned.extend(columns.map(|column| sign * column[constraint]));
        } else {
            let normal = all.normal(constraint);
            self.turned.extend(columns.map(|column| sign * dot(column, normal)));
        }
        self.lost.clear();
        self.lost.extend_from_slice(&self.turned[..q]);
        self.solve_upper();
    }

    /// The minimum with what is active held exactly, refined by the factors; `None` where they are not accurate enough for that.
    pub fn refined(mut self, curvature: &DMatrix<f64>, slope: &DVector<f64>) -> Option<Candidate> {
        let (all, n, q) = (self.all, self.x.len(), self.active.len());
        let (mut rest, mut sizes, mut missing) = (vec![0.0; n], vec![0.0; n], vec![0.0; q]);
        for _ in 0..=REFINEMENTS {
            for held in self.active.iter().filter(|held| held.constraint < all.variables) {
                self.x[held.constraint] = all.limit(held);
            }
            // what B x + slope − Σ multiplier · normal misses 0 by, and the size of its terms; what the active rows miss
            rest.iter_mut().zip(&mut sizes).zip(slope).for_each(|((rest, size), slope)| {
                (*rest, *size) = (-slope, slope.abs());
            });
            let mut add = |entries: &[f64], times: f64| {
                for ((rest, size), entry) in rest.iter_mut().zip(&mut sizes).zip(entries) {
                    *rest += entry * times;
                    *size += (entry * times).abs();
                }
            };
            curvature.as_slice().chunks_exact(n).zip(&self.x).for_each(|(column, x)| add(column, -x));
            let mut is_met = true;
            for (held, missing) in
                self.active.iter().zip(&mut missing).filter(|(held, _)| held.constraint >= all.variables)
            {
                let normal = all.normal(held.constraint);
                add(normal, held.sign * held.multiplier);
                let (limit, value) = (all.limit(held), dot(normal, self.x.as_slice()));
                let size = limit.abs() + normal.iter().zip(&self.x).map(|(a, x)| (a * x).abs()).sum::<f64>();
                *missing = held.sign * (limit - value);
                is_met &= missing.abs() <= ACCURATE * size;
            }
            // the multiplier of an end is what its variable's slope is
            for held in self.active.iter().filter(|held| held.constraint < all.variables) {
                rest[held.constraint] = 0.0;
            }
            if is_met && rest.iter().zip(&sizes).all(|(rest, size)| rest.abs() <= ACCURATE * size) {
                let mut multipliers = vec![0.0; all.limits.len() - all.variables];
                let rows = self.active.iter().filter(|held| held.constraint >= all.variables);
                rows.for_each(|held| multipliers[held.constraint - all.variables] = -held.sign * held.multiplier);
                let level = dot(slope.as_slice(), self.x.as_slice());
                return Some(Candidate { d: self.x, weights: vec![1.0], multipliers, level });
            }
            self.correct(&rest, &missing);
        }
        None
    }

    /// Moves x and the multipliers by the solution of the active set's equations for what these are missed by.
    fn correct(&mut self, rest: &[f64], missing: &[f64]) {
        let (n, q) = (self.x.len(), self.active.len());
        self.turned.clear();
        self.turned.extend(self.j.as_slice().chunks_exact(n).map(|column| dot(column, rest)));
        // along the normals x moves by what Rᵀ makes of the limits that are missed, and the multipliers by what is left there
        self.lost.clear();
        for (c, column) in self.r.as_slice().chunks_exact(n).enumerate().take(q) {
            self.lost.push((missing[c] - dot(&column[..c], &self.lost)) / column[c]);
        }
        for (way, turned) in self.lost.iter_mut().zip(&mut self.turned) {
            (*way, *turned) = (*way - *turned, *way);
        }
        let columns = self.j.as_slice().chunks_exact(n).zip(&self.turned);
        columns.for_each(|(column, way)| add_times(self.x.as_mut_slice(), *way, column));
        self.solve_upper();
        self.active.iter_mut().zip(&self.lost).for_each(|(held, change)| held.multiplier += change);
    }

    /// R⁻¹ of `lost`, in its place.
    fn solve_upper(&mut self) {
        let (n, q) = (self.x.len(), self.active.len());
        for (c, column) in self.r.as_slice().chunks_exact(n).enumerate().take(q).rev() {
            self.lost[c] /= column[c];
            let of_this = -self.lost[c];
            add_times(&mut self.lost[..c], of_this, column);
        }
    }

    /// Adds a constraint to what is active: rotations of the last columns of J leave of Jᵀ normal what R has room for.
    fn add(&mut self, held: Held) {
        let (n, q, d) = (self.x.len(), self.active.len(), &mut self.turned);
        for k in (q + 1..n).rev() {
            let Some(rotation) = Rotation::of(d[k - 1], d[k]) else { continue };
            (d[k - 1], d[k]) = (rotation.length, 0.0);
            rotation.turn_columns(&mut self.j, k - 1);
        }
        self.r.as_mut_slice()[q * n..][..=q].copy_from_slice(&d[..=q]);
        self.is_active[held.constraint] = true;
        self.active.push(held);
    }

    /// Drops one of the active constraints: the columns of R behind it move up, and rotations make it triangular again.
    fn drop(&mut self, at: usize) {
        let q = self.active.len();
        let dropped = self.active.remove(at);
        self.is_active[dropped.constraint] = false;
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

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a + times · b, as far as a goes.
fn add_times(a: &mut [f64], times: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += times * b);
}
