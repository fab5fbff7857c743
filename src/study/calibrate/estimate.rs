use super::calibration::{Calibration, Estimate, Remainder};
use super::refusal::no_answer;
use super::residuals::ShotResiduals;
use super::shot::Shot;
use super::shot_table::ShotTable;
use super::statistics::{Fitted, Statistics};
use super::verdict;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::least_squares::{Fit, Follow, Options, Residuals, Status, fit_from};
use crate::optimize::{Domain, starts};
use crate::parameters::{Setup, Vary, refuse_replaced};
use crate::study::stoppable::stopped;
use crate::units::counted;
use std::sync::atomic::{AtomicBool, Ordering};

/// What to fit, and how.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The parameters with their ranges, whose ends may be infinite.
    pub fit: Vec<Vary>,
    /// Searches, spread over the ranges; the first begins at the setup's own values.
    pub starts: usize,
    /// Loss and limits.
    pub options: Options,
}

impl Plan {
    /// A plan to fit these, by least squares from the setup's own values. A name without a range
    /// has the parameter's own.
    ///
    /// # Errors
    /// As [`Vary::read`]; [`Error::Nothing`] without names.
    pub fn read(setup: &Setup<f64>, fit: &[String]) -> Result<Self> {
        if fit.is_empty() {
            return Err(Error::Nothing {
                doing: "fit",
                what: "parameter",
            });
        }
        let one = |text: &String| match text.contains('=') {
            true => Vary::read(setup, text),
            false => {
                let parameter = setup.variable(text.trim())?;
                Ok(Vary {
                    parameter,
                    low: parameter.range.low,
                    high: parameter.range.high,
                })
            }
        };
        let fit = fit.iter().map(one).collect::<Result<Vec<_>>>()?;
        for (at, vary) in fit.iter().enumerate() {
            if vary.low == vary.high {
                let (name, value) = (vary.parameter.name, vary.parameter.show(Some(vary.low)));
                return Err(Error::Calibration {
                    reason: format!(
                        "the range of {name} is the single value {value}, so nothing is left to \
                         fit; give a wider one, or `set` it"
                    ),
                });
            }
            if fit[..at]
                .iter()
                .any(|other| other.parameter == vary.parameter)
            {
                return Err(Error::Calibration {
                    reason: format!(
                        "{} is to be fitted twice; name it once",
                        vary.parameter.name
                    ),
                });
            }
        }
        Ok(Self {
            fit,
            starts: 1,
            options: Options::default(),
        })
    }

    pub(super) fn check(&self, table: &ShotTable) -> Result<()> {
        let refuse = |reason: String| Err(Error::Calibration { reason });
        for Vary { parameter, .. } in &self.fit {
            if table.is_launched && parameter.is_of_strike() {
                return refuse(format!(
                    "{} cannot be fitted: the rows of {} are launches, which do not use the \
                     parameters of swing, club, strike and \
                     impact; fit what acts on the flight, as aero.cd0",
                    parameter.name, table.file
                ));
            }
            if table.gives(parameter) {
                return refuse(format!(
                    "{} is a column of {}; what the rows give cannot be fitted",
                    parameter.name, table.file
                ));
            }
            let is_stationary = |shot: &Shot| {
                shot.stationary
                    .iter()
                    .any(|stationary| stationary.parameter == *parameter)
            };
            if table.shots.iter().any(is_stationary) {
                return refuse(format!(
                    "{} cannot be fitted to rows that are optima in it",
                    parameter.name
                ));
            }
        }
        let inputs = table
            .shots
            .iter()
            .take(1)
            .flat_map(|shot| &shot.inputs)
            .map(|(parameter, _)| parameter.name);
        let names: Vec<_> = inputs
            .chain(self.fit.iter().map(|vary| vary.parameter.name))
            .collect();
        refuse_replaced(&names, |_| false)?;
        for (row, measured) in table
            .shots
            .iter()
            .flat_map(|shot| shot.measured.iter().map(|one| (shot.row, one)))
        {
            let (of, value, sigma) = (measured.outcome, measured.value, measured.sigma);
            if !(value.is_finite() && sigma > 0.0 && sigma.is_finite()) {
                return refuse(format!(
                    "row {row}: {} was measured as {} with a standard uncertainty of {}; give a \
                     finite value, and an uncertainty above 0",
                    of.name(),
                    of.show(value),
                    of.show(sigma)
                ));
            }
        }
        for (row, at) in table
            .shots
            .iter()
            .flat_map(|shot| shot.stationary.iter().map(|one| (shot.row, one)))
        {
            if !(at.sigma > 0.0 && at.sigma.is_finite()) {
                let sigma = at.parameter.show(Some(at.sigma));
                return refuse(format!(
                    "row {row} is an optimum in {} with a standard uncertainty of {sigma}; give \
                     one above 0",
                    at.parameter
                ));
            }
        }
        if table.residuals() < self.fit.len() {
            return refuse(format!(
                "{} has {}, fewer than the {} to fit; add measured shots, or fit fewer parameters",
                table.file,
                counted(table.residuals() as u64, "measured value"),
                counted(self.fit.len() as u64, "parameter")
            ));
        }
        Ok(())
    }
}

/// Fits parameters of a setup to measured shots.
///
/// Rows with a stationary parameter enter with the angle by which carry's optimum is missed,
/// −slope/|curvature|; the curvature is held while the search runs, and renewed until it stays.
///
/// # Errors
/// [`Error::Calibration`] for a plan that does not fit the table, and for measured values that are
/// not finite or have no standard uncertainty above 0; [`Error::OtherLaw`] and
/// [`Error::SearchRange`] for what is to be fitted; [`Error::NoFit`] where rows do not fly at any
/// start, with each of them; [`Error::NotConverged`] where it is stopped before the fit has begun.
pub fn calibrate(
    setup: &Setup<f64>,
    table: &ShotTable,
    plan: &Plan,
    follow: &Follow,
) -> Result<Calibration> {
    /// Curvatures are renewed at most so often, until none changes by more than this part.
    const RENEWALS: usize = 8;
    const SAME: f64 = 1e-4;
    /// Points tried for a start where not every row flies at those given.
    const START_TRIALS: usize = 64;
    plan.check(table)?;
    for vary in &plan.fit {
        setup.check_variable(vary.parameter)?;
        vary.check()?;
    }
    let fitted: Vec<_> = plan.fit.iter().map(|vary| vary.parameter).collect();
    let ends = |end: fn(&Vary) -> f64| plan.fit.iter().map(end).collect::<Vec<_>>();
    let domain = Domain::new(ends(|vary| vary.low), ends(|vary| vary.high))?;
    let own: Vec<f64> = fitted
        .iter()
        .filter_map(|parameter| setup.value(parameter))
        .collect();
    let own = domain.variables.project(&own);
    let mut problem = ShotResiduals {
        setup: *setup,
        shots: &table.shots,
        fitted,
        curvatures: vec![],
        stop: &follow.interrupt,
    };
    let options = Options {
        rounding: table.rounding(),
        ..plan.options.clone()
    };
    let mut from = starts(&domain, &own, plan.starts)?;
    if !from.iter().any(|start| problem.begin(start)) {
        let unbegun = || follow.is_interrupted().then(|| stopped("the fit began"));
        if let Some(stopped) = unbegun() {
            return Err(stopped);
        }
        // as a search does whose functions are not defined at its start, others are tried
        let others = starts(&domain, &own, START_TRIALS)?;
        from = others
            .into_iter()
            .filter(|start| problem.begin(start))
            .take(1)
            .collect();
        if from.is_empty() {
            return Err(unbegun().unwrap_or_else(|| missing(NO_START, &problem, &own)));
        }
    }
    let mut renewals = 0;
    let (mut fits, is_settled) = loop {
        let fits = fit_from(&problem, &domain, &from, &options, follow)?;
        let best = &fits[0];
        if best.rows.residuals.is_empty() {
            return Err(if follow.is_interrupted() {
                stopped("the fit began")
            } else {
                missing(NO_START, &problem, &own)
            });
        }
        let renewed = match problem.curvatures_at(&best.x) {
            // without optima among the rows there is nothing to renew
            Err(_) if follow.is_interrupted() => {
                break (
                    fits,
                    table.shots.iter().all(|shot| shot.stationary.is_empty()),
                );
            }
            renewed => renewed?,
        };
        let pairs = renewed
            .iter()
            .flatten()
            .zip(problem.curvatures.iter().flatten());
        let is_same = pairs
            .clone()
            .all(|(new, old)| (new / old - 1.0).abs() <= SAME);
        if is_same || renewals == RENEWALS || follow.is_interrupted() {
            break (fits, is_same);
        }
        renewals += 1;
        from = if renewals == 1 {
            fits.iter().map(|fit| fit.x.clone()).collect()
        } else {
            vec![best.x.clone()]
        };
        problem.curvatures = renewed;
    };
    let is_same =
        |fit: &&Fit| (fit.cost - fits[0].cost).abs() <= 1e-6 * fits[0].cost.abs().max(1e-12);
    let (at_the_sum, others): (Vec<&Fit>, Vec<_>) = fits
        .iter()
        .filter(|fit| fit.status != Status::Interrupted)
        .partition(is_same);
    let (same, mut elsewhere) = (at_the_sum.len(), vec![]);
    for Fit { status, .. } in others {
        match elsewhere.iter_mut().find(|(other, _)| other == status) {
            Some((_, count)) => *count += 1,
            None => elsewhere.push((*status, 1)),
        }
    }
    let (stopped, is_minimum) =
        verdict::of_searches(&mut fits, is_settled, follow.is_interrupted());
    let mut found = finished(&problem, &domain, table, &own, fits, &options)?;
    verdict::of_data(&mut found, options.loss, table.uncertainties);
    Ok(Calibration {
        starts: (plan.starts, same),
        elsewhere,
        stopped,
        is_minimum,
        renewals,
        ..found
    })
}

/// What a fit lacks that cannot begin.
const NO_START: &str = "no start was found at which every row has an answer";

/// The error for the rows that have no answer at a point.
fn missing(what: &str, problem: &ShotResiduals<'_>, at: &[f64]) -> Error {
    match problem.each(at) {
        Ok(each) => {
            let rows = problem.shots.iter().zip(each);
            no_answer(
                what,
                &rows
                    .filter_map(|(shot, row)| row.err().map(|why| (shot.row, why)))
                    .collect::<Vec<_>>(),
            )
        }
        Err(error) => Error::Calibration {
            reason: error.to_string(),
        },
    }
}

fn finished(
    problem: &ShotResiduals<'_>,
    domain: &Domain,
    table: &ShotTable,
    own: &[f64],
    fits: Vec<Fit>,
    options: &Options,
) -> Result<Calibration> {
    /// A range without an end is taken to reach this many times the parameter's own size (or 0.001,
    /// if that is more).
    const ENDLESS: f64 = 1e6;
    let fit = fits.into_iter().next().ok_or(Error::Nothing {
        doing: "fit",
        what: "start",
    })?;
    let bounds = &domain.variables;
    let fitted = (0..fit.x.len()).map(|i| {
        let (x, low, high) = (fit.x[i], bounds.low[i], bounds.high[i]);
        let width = high - low;
        let size = x.abs().max(own[i].abs()).max(1e-3);
        Fitted {
            is_free: low < x && x < high,
            width: if width.is_finite() {
                width
            } else {
                ENDLESS * size
            },
        }
    });
    let fitted: Vec<Fitted> = fitted.collect();
    let statistics = Statistics::new(
        &fit.rows,
        &fitted,
        table.uncertainties,
        options.rounding,
        options.loss,
    )?;
    let estimates = problem
        .fitted
        .iter()
        .enumerate()
        .map(|(i, parameter)| Estimate {
            parameter,
            value: fit.x[i],
            standard_error: statistics.standard_error(i),
            is_at_bound: !fitted[i].is_free,
            is_determined: statistics.determines(i),
        });
    let estimates = estimates.collect();
    let remainders = remainders(&table.shots, &fit.rows.residuals);
    let setup = problem.moved(&fit.x)?;
    Ok(Calibration {
        setup,
        fit,
        starts: (1, 1),
        elsewhere: vec![],
        stopped: 0,
        is_minimum: false,
        estimates,
        statistics,
        remainders,
        renewals: 0,
    })
}

/// Residuals with what they are of.
pub(super) fn remainders(shots: &[Shot], residuals: &[f64]) -> Vec<Remainder> {
    let of = |shot: &Shot| {
        let row = shot.row;
        let measured = shot
            .measured
            .iter()
            .map(move |m| (row, m.outcome, None, Some(m.value), m.sigma));
        let stationary = shot
            .stationary
            .iter()
            .map(move |s| (row, Outcome::Carry, Some(s.parameter), None, s.sigma));
        measured.chain(stationary).collect::<Vec<_>>()
    };
    let all = shots.iter().flat_map(of).zip(residuals);
    all.map(
        |((row, outcome, stationary, measured, sigma), residual)| Remainder {
            row,
            outcome,
            stationary,
            measured,
            difference: residual * sigma,
            residual: *residual,
        },
    )
    .collect()
}

/// The residuals of shots flown with a setup as it stands; nothing once `stop` is true.
pub(super) fn flown(
    setup: &Setup<f64>,
    shots: &[Shot],
    stop: &AtomicBool,
) -> Result<Option<Vec<Remainder>>> {
    let mut problem = ShotResiduals {
        setup: *setup,
        shots,
        fitted: vec![],
        curvatures: vec![],
        stop,
    };
    let is_begun = problem.begin(&[]);
    if stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    if !is_begun {
        return Err(missing(
            "rows to be predicted have no answer",
            &problem,
            &[],
        ));
    }
    let rows = match problem.evaluate(&[]) {
        Err(_) if stop.load(Ordering::Relaxed) => return Ok(None),
        rows => rows.map_err(|reason| Error::Calibration { reason })?,
    };
    Ok(Some(remainders(shots, &rows.residuals)))
}
