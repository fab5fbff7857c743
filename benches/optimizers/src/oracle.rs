//! A problem for a solver. It counts its evaluations, and excludes their time from the solver's
//! time.

use crate::problems::Case;
use longdrive::number::Taylor;
use longdrive::optimize::Evaluation;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// A problem that counts the points at which it is evaluated. All functions and derivatives at one
/// x count once.
pub struct Oracle<'a> {
    pub case: &'a Case,
    known: RefCell<HashMap<Vec<u64>, Rc<Evaluation>>>,
    spent: Cell<Duration>,
}

impl<'a> Oracle<'a> {
    pub fn new(case: &'a Case) -> Self {
        Self {
            case,
            known: RefCell::default(),
            spent: Cell::default(),
        }
    }

    /// Evaluates the functions at `x` and passes their values to `read`, which converts them for
    /// the solver. Neither the evaluation nor `read` counts as the solver's time.
    pub fn read<R>(&self, x: &[f64], read: impl FnOnce(&Evaluation) -> R) -> R {
        let started = Instant::now();
        let at = self.evaluation(x);
        let result = read(&at);
        self.spent.set(self.spent.get() + started.elapsed());
        result
    }

    fn evaluation(&self, x: &[f64]) -> Rc<Evaluation> {
        let key: Vec<u64> = x.iter().map(|x| x.to_bits()).collect();
        let mut known = self.known.borrow_mut();
        known
            .entry(key)
            .or_insert_with(|| Rc::new(evaluate(self.case, x)))
            .clone()
    }

    pub fn evaluations(&self) -> usize {
        self.known.borrow().len()
    }

    /// Time spent in [`read`](Self::read).
    pub fn spent(&self) -> Duration {
        self.spent.get()
    }
}

/// The functions and their derivatives at `x`; NaN where they are undefined.
pub fn evaluate(case: &Case, x: &[f64]) -> Evaluation {
    let n = x.len();
    let undefined = || Taylor {
        value: f64::NAN,
        gradient: vec![f64::NAN; n],
        hessian: vec![vec![f64::NAN; n]; n],
    };
    (case.evaluate)(x).unwrap_or_else(|_| Evaluation {
        objective: undefined(),
        constraints: case.least.iter().map(|_| undefined()).collect(),
    })
}

/// The published start, moved into the bounds. Every solver starts here.
pub fn start(case: &Case) -> Vec<f64> {
    case.start
        .iter()
        .enumerate()
        .map(|(i, x)| x.clamp(case.low[i], case.high[i]))
        .collect()
}

/// A limit of a constraint function c, for solvers with one-sided limits: sign · (c − limit) is 0
/// for an equality, and ≤ 0 for an inequality.
#[derive(Clone, Copy)]
pub struct Row {
    pub constraint: usize,
    pub sign: f64,
    pub limit: f64,
}

impl Row {
    pub fn value(&self, at: &Evaluation) -> f64 {
        self.sign * (at.constraints[self.constraint].value - self.limit)
    }

    pub fn slope(&self, at: &Evaluation, i: usize) -> f64 {
        self.sign * at.constraints[self.constraint].gradient[i]
    }
}

/// The constraints of a problem as rows: the equalities, and the inequalities.
pub fn rows(case: &Case) -> (Vec<Row>, Vec<Row>) {
    let (mut equalities, mut inequalities) = (vec![], vec![]);
    for (constraint, (&least, &most)) in case.least.iter().zip(case.most).enumerate() {
        if least == most {
            equalities.push(Row {
                constraint,
                sign: 1.0,
                limit: most,
            });
            continue;
        }
        if most.is_finite() {
            inequalities.push(Row {
                constraint,
                sign: 1.0,
                limit: most,
            });
        }
        if least.is_finite() {
            inequalities.push(Row {
                constraint,
                sign: -1.0,
                limit: least,
            });
        }
    }
    (equalities, inequalities)
}
