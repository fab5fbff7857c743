use super::calibration::{Calibration, Estimate, FitResidual, Starts};
use super::refusal::failed_rows_error;
use super::residuals::ShotResiduals;
use super::shot_table::{MeasuredShot, ShotTable};
use super::statistics::{FitRange, FitStatistics};
use super::verdict;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::least_squares::{Fit, FitObserver, FitOptions, FitStatus, fit_from};
use crate::optimize::{Domain, starts};
use crate::parameters::{Parameter, Setup, Vary, refuse_replaced};
use crate::study::cancellable::stopped_before;
use crate::units::counted;
use std::sync::atomic::{AtomicBool, Ordering};

/// Parameters to fit, and options of the fit.
#[derive(Clone, Debug)]
pub struct FitPlan {
    /// The parameters with their ranges; a range may be unbounded.
    pub fit: Vec<Vary>,
    /// Number of searches. The first starts at the setup's values; the others start at points
    /// spread over the ranges.
    pub starts: usize,
    /// Loss function and limits of the search.
    pub options: FitOptions,
}

impl FitPlan {
    /// A plan to fit parameters, given as texts `NAME` or `NAME=LOW..HIGH`, by least squares from
    /// the setup's values. Without `LOW..HIGH`, the range is the parameter's allowed range.
    ///
    /// # Errors
    /// [`Error::Nothing`] if `fit` is empty; [`Error::Calibration`] if a parameter occurs twice or
    /// a range is a single value; the errors of [`Vary::read`].
    pub fn read(setup: &Setup<f64>, fit: &[String]) -> Result<Self> {
        if fit.is_empty() {
            return Err(Error::Nothing {
                doing: "fit",
                what: "parameter, as in `fit aero.cd0` or `fit aero.cd0=0.1..0.4`",
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
                        "the range of {name} is the single value {value}, so that nothing is left \
                         to fit; give a wider range, or fix the value with `set`"
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
            options: FitOptions::default(),
        })
    }

    pub(super) fn check(&self, table: &ShotTable) -> Result<()> {
        let refuse = |reason: String| Err(Error::Calibration { reason });
        for Vary { parameter, .. } in &self.fit {
            if table.is_launched && parameter.is_of_strike() {
                return refuse(format!(
                    "{} cannot be fitted: the rows of {} are launches, which do not use the \
                     parameters of swing, club, strike and impact; fit parameters of the flight, \
                     for example aero.cd0",
                    parameter.name, table.file
                ));
            }
            if table.gives(parameter) {
                return refuse(format!(
                    "{} is a column of {}; a parameter with values in the table cannot be fitted",
                    parameter.name, table.file
                ));
            }
            let is_stationary = |shot: &MeasuredShot| {
                shot.stationary
                    .iter()
                    .any(|stationary| stationary.parameter == *parameter)
            };
            if table.shots.iter().any(is_stationary) {
                return refuse(format!(
                    "{} cannot be fitted: a row states that its carry is the largest over this \
                     angle",
                    parameter.name
                ));
            }
        }
        for shot in &table.shots {
            let inputs = shot.inputs.iter().map(|(parameter, _)| parameter.name);
            let fitted = self.fit.iter().map(|vary| vary.parameter.name);
            let names: Vec<_> = inputs.chain(fitted).collect();
            refuse_replaced(&names, |_| false)?;
        }
        check_measurements(&table.shots)?;
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

/// Refuses measured values that are not finite, and standard uncertainties that are not positive.
fn check_measurements(shots: &[MeasuredShot]) -> Result<()> {
    let refuse = |reason: String| Err(Error::Calibration { reason });
    for (row, measured) in shots
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
    for (row, at) in shots
        .iter()
        .flat_map(|shot| shot.stationary.iter().map(|one| (shot.row, one)))
    {
        if !(at.sigma > 0.0 && at.sigma.is_finite()) {
            let sigma = at.parameter.show(Some(at.sigma));
            return refuse(format!(
                "row {row}: the stationary parameter {} has a standard uncertainty of {sigma}; \
                 give an uncertainty above 0",
                at.parameter
            ));
        }
    }
    Ok(())
}

/// Fits parameters of a setup to measured shots by least squares.
///
/// A row may state that its carry is greatest at the row's value of a parameter. The residual of
/// this statement is slope/|curvature| of the carry in the parameter: to first order, the parameter
/// at the computed maximum minus the row's value. The curvature is constant during a search. After
/// each search it is computed anew, until it no longer changes.
///
/// # Errors
/// [`Error::Calibration`] if the rows state a parameter to fit or do not depend on it, if there are
/// fewer measured values than parameters to fit, or if a measured value is not finite or has no
/// standard uncertainty above 0; [`Error::OtherLaw`] for a coefficient of another law;
/// [`Error::SearchRange`] for an invalid range; [`Error::NoFit`] if no starting point was found
/// from which every row can be computed; [`Error::NotConverged`] if the fit is interrupted before
/// it begins.
pub fn calibrate(
    setup: &Setup<f64>,
    table: &ShotTable,
    plan: &FitPlan,
    observer: &FitObserver,
) -> Result<Calibration> {
    plan.check(table)?;
    for vary in &plan.fit {
        setup.check_variable(vary.parameter)?;
        vary.check()?;
    }
    let fitted: Vec<_> = plan.fit.iter().map(|vary| vary.parameter).collect();
    let (low, high) = plan.fit.iter().map(|vary| (vary.low, vary.high)).unzip();
    let domain = Domain::new(low, high)?;
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
        stop: &observer.interrupt,
    };
    let options = FitOptions {
        rounding: table.rounding(),
        ..plan.options.clone()
    };
    let from = starting_points(&mut problem, &domain, &own, plan.starts, observer)?;
    let made = from.len();
    let mut searches =
        RepeatedSearches::run(&mut problem, &domain, &own, from, &options, observer)?;
    let starts = searches.by_end(made);
    let is_stopped = |fit: &&Fit| fit.status == FitStatus::Interrupted;
    let stopped = searches.fits.iter().filter(is_stopped).count();
    let is_minimum = searches.is_settled && searches.fits[0].status == FitStatus::Converged;
    let of_searches = verdict::of_searches(
        &searches.fits,
        searches.is_settled,
        observer.is_interrupted(),
    );
    let fit = searches.fits.swap_remove(0);
    let ranges = ranges_of(&fit.x, &own, &domain);
    let (origin, rounding, loss) = (table.sigma_origin, options.rounding, options.loss);
    let statistics = FitStatistics::new(&fit.rows, &ranges, origin, rounding, loss)?;
    let mut found = Calibration {
        setup: problem.moved(&fit.x)?,
        starts,
        stopped,
        is_minimum,
        estimates: estimates(&problem.fitted, &fit.x, &ranges, &statistics),
        residuals: residuals(&table.shots, &fit.rows.residuals),
        statistics,
        verdict: of_searches,
        fit,
    };
    if let Some(of_data) = verdict::of_data(&found, loss, origin) {
        found.verdict = of_data;
    }
    Ok(found)
}

/// Starting points of the searches. At one of them at least, every row can be computed.
fn starting_points(
    problem: &mut ShotResiduals<'_>,
    domain: &Domain,
    own: &[f64],
    count: usize,
    observer: &FitObserver,
) -> Result<Vec<Vec<f64>>> {
    /// Number of starting points to try if the residuals are undefined at all planned starting
    /// points.
    const START_TRIALS: usize = 64;
    let planned = starts(domain, own, count)?;
    if planned.iter().any(|start| problem.begin(start)) {
        return Ok(planned);
    }
    if observer.is_interrupted() {
        return Err(stopped_before("the fit began"));
    }
    let other = starts(domain, own, START_TRIALS)?
        .into_iter()
        .find(|start| problem.begin(start));
    match other {
        Some(start) => Ok(vec![start]),
        None => Err(no_start(problem, own, observer)),
    }
}

fn no_start(problem: &ShotResiduals<'_>, own: &[f64], observer: &FitObserver) -> Error {
    if observer.is_interrupted() {
        stopped_before("the fit began")
    } else {
        let what = "no starting point was found from which every row can be computed";
        missing(what, problem, own)
    }
}

/// Searches from several starting points, repeated until [`ShotResiduals::curvatures`] no longer
/// change.
struct RepeatedSearches {
    /// Fits in ascending order of the sum of squares.
    fits: Vec<Fit>,
    /// True if the curvatures no longer change.
    is_settled: bool,
}

impl RepeatedSearches {
    /// Runs the searches. Repeats them with the curvatures at the best point until these no longer
    /// change.
    fn run(
        problem: &mut ShotResiduals<'_>,
        domain: &Domain,
        own: &[f64],
        mut from: Vec<Vec<f64>>,
        options: &FitOptions,
        observer: &FitObserver,
    ) -> Result<Self> {
        /// Maximum number of renewals.
        const RENEWALS: usize = 8;
        /// A curvature counts as unchanged up to this relative change.
        const SAME: f64 = 1e-4;
        let mut renewals = 0;
        loop {
            let residuals = |x: &[f64]| problem.evaluate(x);
            let fits = fit_from(&residuals, domain, &from, options, observer)?;
            let best = &fits[0];
            if best.rows.residuals.is_empty() {
                return Err(no_start(problem, own, observer));
            }
            let renewed = match problem.curvatures_at(&best.x) {
                // the new curvatures are unknown: the fit is settled only if no shot needs
                // curvatures
                Err(_) if observer.is_interrupted() => {
                    let is_settled = problem.shots.iter().all(|shot| shot.stationary.is_empty());
                    return Ok(Self { fits, is_settled });
                }
                renewed => renewed?,
            };
            let is_settled = renewed
                .iter()
                .flatten()
                .zip(problem.curvatures.iter().flatten())
                .all(|(new, old)| (new / old - 1.0).abs() <= SAME);
            if is_settled || renewals == RENEWALS || observer.is_interrupted() {
                return Ok(Self { fits, is_settled });
            }
            renewals += 1;
            from = if renewals == 1 {
                fits.iter().map(|fit| fit.x.clone()).collect()
            } else {
                vec![best.x.clone()]
            };
            problem.curvatures = renewed;
        }
    }

    /// Counts the completed searches that reached the smallest sum of squares, and the others by
    /// status. `made` is the number of starting points.
    fn by_end(&self, made: usize) -> Starts {
        let best = self.fits[0].cost;
        let is_same = |fit: &&Fit| (fit.cost - best).abs() <= 1e-6 * best.abs().max(1e-12);
        let (at_best, larger): (Vec<&Fit>, Vec<_>) = self
            .fits
            .iter()
            .filter(|fit| fit.status != FitStatus::Interrupted)
            .partition(is_same);
        let mut others: Vec<(FitStatus, usize)> = vec![];
        for Fit { status, .. } in larger {
            match others.iter_mut().find(|(other, _)| other == status) {
                Some((_, count)) => *count += 1,
                None => others.push((*status, 1)),
            }
        }
        Starts {
            made,
            at_best: at_best.len(),
            others,
        }
    }
}

/// Error for rows whose drives cannot be computed at the values `at` of the fitted parameters. The
/// message begins with `what` and lists the rows.
fn missing(what: &str, problem: &ShotResiduals<'_>, at: &[f64]) -> Error {
    let by_shot = problem.moved(at).and_then(|moved| problem.by_shot(&moved));
    match by_shot {
        Ok(by_shot) => {
            let rows = problem.shots.iter().zip(by_shot);
            failed_rows_error(
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

/// The estimates of the fitted parameters, whose values are `x`.
fn estimates(
    fitted: &[&'static Parameter],
    x: &[f64],
    ranges: &[FitRange],
    statistics: &FitStatistics,
) -> Vec<Estimate> {
    let estimate = |(i, parameter): (usize, &&'static Parameter)| {
        let (value, standard_error) = (x[i], statistics.standard_error(i));
        Estimate {
            parameter,
            value,
            standard_error,
            interval_95: standard_error.map(|error| {
                let half_width = statistics.coverage_factor * error;
                [value - half_width, value + half_width]
            }),
            is_at_bound: !ranges[i].is_free,
            is_determined: statistics.determines(i),
        }
    };
    fitted.iter().enumerate().map(estimate).collect()
}

/// Position of each fitted parameter in its range, and width of the range. `x` has the fitted
/// values, `own` the values of the setup.
fn ranges_of(x: &[f64], own: &[f64], domain: &Domain) -> Vec<FitRange> {
    /// An unbounded range is taken to be as wide as this multiple of the parameter's magnitude,
    /// max(|fitted value|, |value of the setup|, 0.001), SI.
    const ENDLESS: f64 = 1e6;
    let bounds = &domain.variables;
    let range = |i: usize| {
        let (x, low, high) = (x[i], bounds.low[i], bounds.high[i]);
        let width = high - low;
        let size = x.abs().max(own[i].abs()).max(1e-3);
        FitRange {
            is_free: low < x && x < high,
            width: if width.is_finite() {
                width
            } else {
                ENDLESS * size
            },
        }
    };
    (0..x.len()).map(range).collect()
}

/// The residuals with their rows and outcomes.
pub(super) fn residuals(shots: &[MeasuredShot], residuals: &[f64]) -> Vec<FitResidual> {
    let of = |shot: &MeasuredShot| {
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
        |((row, outcome, stationary, measured, sigma), residual)| FitResidual {
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

/// Residuals of shots flown with a given setup, without a fit; `None` once `stop` is true.
pub(super) fn flown(
    setup: &Setup<f64>,
    shots: &[MeasuredShot],
    stop: &AtomicBool,
) -> Result<Option<Vec<FitResidual>>> {
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
            "drives of the rows to be predicted cannot be computed",
            &problem,
            &[],
        ));
    }
    let rows = match problem.evaluate(&[]) {
        Err(_) if stop.load(Ordering::Relaxed) => return Ok(None),
        rows => rows.map_err(|reason| Error::Calibration { reason })?,
    };
    Ok(Some(residuals(shots, &rows.residuals)))
}
