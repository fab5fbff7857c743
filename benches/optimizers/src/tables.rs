//! Tables: comparison of the solvers, and longdrive's result for every problem.

use crate::judge::{Judgement, judge};
use crate::outcome::Outcome;
use crate::peers::PEERS;
use crate::problems::Case;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

const SOLVED: f64 = 1e-6;
const STRICTLY: f64 = 1e-8;
const OURS: &str = "longdrive";

struct Run<'a> {
    case: &'a Case,
    outcome: &'a Outcome,
    judgement: Judgement,
}

impl Run<'_> {
    fn is_solved(&self, tolerance: f64) -> bool {
        self.judgement.residual() <= tolerance
    }
}

/// The runs of a solver, by the name of the problem.
struct Record<'a> {
    solver: &'a str,
    is_general: bool,
    runs: BTreeMap<&'a str, Run<'a>>,
}

impl Record<'_> {
    fn has_solved(&self, problem: &str) -> bool {
        self.runs
            .get(problem)
            .is_some_and(|run| run.is_solved(SOLVED))
    }

    fn count(&self, is_counted: impl Fn(&Run) -> bool) -> usize {
        self.runs.values().filter(|run| is_counted(run)).count()
    }

    fn sum(&self, problems: &[&str], of: impl Fn(&Outcome) -> f64) -> f64 {
        problems
            .iter()
            .filter_map(|problem| self.runs.get(problem))
            .map(|run| of(run.outcome))
            .sum()
    }

    /// Median of the ratio `of(outcome)` of this solver to `of(outcome)` of the solver `other`,
    /// over `problems`.
    fn ratio(&self, other: &Self, problems: &[&str], of: impl Fn(&Outcome) -> f64) -> f64 {
        let both = problems
            .iter()
            .filter_map(|problem| Some((self.runs.get(problem)?, other.runs.get(problem)?)));
        let mut ratios: Vec<f64> = both
            .map(|(run, ours)| of(run.outcome) / of(ours.outcome))
            .collect();
        ratios.sort_by(f64::total_cmp);
        match ratios.len() {
            0 => f64::NAN,
            count => (ratios[(count - 1) / 2] + ratios[count / 2]) / 2.0,
        }
    }
}

/// Writes `solvers.md`, `problems.md` and `outcomes.jsonl`, and prints `solvers.md`.
pub fn write(cases: &[Case], outcomes: &[Outcome], directory: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(directory)?;
    let records = records(cases, outcomes);
    let solvers = solvers(&records)?;
    std::fs::write(directory.join("solvers.md"), &solvers)?;
    std::fs::write(directory.join("problems.md"), problems(cases, &records)?)?;
    std::fs::write(directory.join("outcomes.jsonl"), lines(&records)?)?;
    print!("{solvers}");
    Ok(())
}

fn records<'a>(cases: &'a [Case], outcomes: &'a [Outcome]) -> Vec<Record<'a>> {
    let mut records: Vec<Record> = vec![];
    for outcome in outcomes {
        let Some(case) = cases.iter().find(|case| case.name == outcome.problem) else {
            continue;
        };
        let run = Run {
            case,
            outcome,
            judgement: judge(case, &outcome.point()),
        };
        match records
            .iter_mut()
            .find(|record| record.solver == outcome.solver)
        {
            Some(record) => _ = record.runs.insert(case.name, run),
            None => {
                let is_general = !PEERS
                    .iter()
                    .any(|peer| peer.name == outcome.solver && peer.is_for_bounds_only);
                let runs = BTreeMap::from([(case.name, run)]);
                records.push(Record {
                    solver: &outcome.solver,
                    is_general,
                    runs,
                });
            }
        }
    }
    records
}

fn solvers(records: &[Record]) -> Result<String, Box<dyn Error>> {
    let ours = records
        .iter()
        .find(|record| record.solver == OURS)
        .ok_or("longdrive did not run")?;
    let common: Vec<&str> = ours
        .runs
        .keys()
        .copied()
        .filter(|problem| {
            records
                .iter()
                .filter(|record| record.is_general)
                .all(|record| record.has_solved(problem))
        })
        .collect();
    let mut table = format!(
        "| Solver | Tried | Solved (1e-6) | Of these at the published optimum | Strictly solved \
         (1e-8) \
         | Evaluations, {0} common problems | Own time, {0} common problems | Median evaluations, \
         per problem \
         | Median own time, per problem |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
        common.len()
    );
    let evaluations = |outcome: &Outcome| outcome.evaluations as f64;
    let seconds = |outcome: &Outcome| outcome.seconds;
    for record in records {
        let totals = if record.is_general {
            let times = record.sum(&common, seconds) / ours.sum(&common, seconds);
            format!("{} | {} ×", record.sum(&common, evaluations), digits(times))
        } else {
            "– | –".into()
        };
        let both: Vec<&str> = record
            .runs
            .keys()
            .copied()
            .filter(|problem| record.has_solved(problem) && ours.has_solved(problem))
            .collect();
        writeln!(
            table,
            "| {} | {} | {} | {} | {} | {totals} | {} × | {} × |",
            record.solver,
            record.runs.len(),
            record.count(|run| run.is_solved(SOLVED)),
            record.count(
                |run| run.is_solved(SOLVED) && run.judgement.is_at_published_optimum(run.case)
            ),
            record.count(|run| run.is_solved(STRICTLY)),
            digits(record.ratio(ours, &both, evaluations)),
            digits(record.ratio(ours, &both, seconds)),
        )?;
    }
    Ok(table)
}

/// A ratio as text: without decimals from 10, with one decimal from 1, else with two.
fn digits(ratio: f64) -> String {
    match ratio.abs() {
        size if size >= 10.0 => format!("{ratio:.0}"),
        size if size >= 1.0 => format!("{ratio:.1}"),
        _ => format!("{ratio:.2}"),
    }
}

fn problems(cases: &[Case], records: &[Record]) -> Result<String, Box<dyn Error>> {
    let ours = records
        .iter()
        .find(|record| record.solver == OURS)
        .ok_or("longdrive did not run")?;
    let mut table = String::from(
        "| Problem | n | m | Iterations | Evaluations | Status | KKT residual (judge) | f | \
         Published f* \
         | Not solved by |\n|---|--:|--:|--:|--:|---|--:|--:|--:|---|\n",
    );
    for case in cases {
        let Some(run) = ours.runs.get(case.name) else {
            continue;
        };
        let failed: Vec<&str> = records
            .iter()
            .filter(|record| record.runs.contains_key(case.name) && !record.has_solved(case.name))
            .map(|record| record.solver)
            .collect();
        writeln!(
            table,
            "| {} | {} | {} | {} | {} | {} | {:.0e} | {:.9e} | {:.9e} | {} |",
            case.name,
            case.start.len(),
            case.least.len(),
            run.outcome
                .iterations
                .map_or("–".into(), |iterations| iterations.to_string()),
            run.outcome.evaluations,
            run.outcome.status,
            run.judgement.residual(),
            run.judgement.value,
            case.optimum,
            failed.join(", "),
        )?;
    }
    Ok(table)
}

/// Every outcome with its judgement, as lines of JSON.
fn lines(records: &[Record]) -> Result<String, Box<dyn Error>> {
    let mut lines = String::new();
    for run in records.iter().flat_map(|record| record.runs.values()) {
        let mut line = serde_json::to_value(run.outcome)?;
        line["feasibility"] = run.judgement.feasibility.into();
        line["stationarity"] = run.judgement.stationarity.into();
        line["complementarity"] = run.judgement.complementarity.into();
        line["f"] = run.judgement.value.into();
        writeln!(lines, "{line}")?;
    }
    Ok(lines)
}
