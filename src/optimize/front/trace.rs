//! Traces the front from one end to the other, and spreads points evenly along it.

use super::compromise::{Compromise, FrontPlane};
use super::context::{FrontContext, PART_MISSING, SAME, span_of};
use super::result::{Front, FrontEvent};
use crate::error::Result;
use crate::optimize::continuation::{AdaptiveStep, TOO_FAR, locate_change};
use crate::optimize::sensitivity::ActiveSet;
use crate::optimize::solution::Solution;

/// Accuracy of the position s of an event along the front.
const LOCATED: f64 = 1e-9;

/// Reason for a front with a missing part.
const NO_COMPROMISE: &str = "no compromise was found in a part of the front";

/// Largest distance in s from the end of the front at which a trace has reached the end.
const END_REACHED: f64 = 0.01;

/// A front has a knee only if its distance from the straight line between its ends is at least this
/// fraction of the length of that line.
const STRAIGHT: f64 = 0.01;

/// A point is a kink of the front if the slopes on its two sides differ by more than this fraction.
const KINK: f64 = 1e-3;

/// A traced path, and the reason if a part of it is missing.
struct TracedPath {
    points: Vec<Compromise>,
    ended: Option<String>,
}

/// Computes the front between the minima of the two functions.
pub(super) fn trace_front(
    context: &FrontContext<'_>,
    ends: [Solution; 2],
    values: [[f64; 2]; 2],
    count: usize,
) -> Result<Front> {
    let plane = FrontPlane {
        context,
        zero: std::array::from_fn(|k| values[k][k]),
        span: std::array::from_fn(|k| span_of(values, k)),
    };
    let [first, second] = [0, 1].map(|k| plane.end(k, &ends[k], values[k]));
    let TracedPath {
        points: path,
        mut ended,
    } = trace_from_both_ends(&plane, first, second);
    let mut points = spread_evenly(&plane, &path, count);
    let mut interrupted = context.is_interrupted();
    // after an interrupt during tracing, return the points of the traced path
    if interrupted && points.len() < 3 {
        points.clone_from(&path);
    }
    let knee = if interrupted {
        None
    } else {
        find_knee(&plane, &path)
    };
    interrupted = interrupted || context.is_interrupted();
    if interrupted {
        ended = Some(PART_MISSING.into());
    }
    let sums = path.iter().chain(&knee).map(|place| place.sum);
    let smallest_sum = sums.fold(1.0, f64::min);
    let knee_at = knee.as_ref().map(|knee| knee.at);
    points.extend(knee);
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    let (mut points, dominated) = nondominated(points, &path, plane.span);
    // at an end of the front, take the active set from the minimization of a single function: in a
    // search for a compromise the multipliers at the end are 0
    for place in points.iter_mut().filter(|place| place.at.abs() >= 1.0) {
        let end = &ends[usize::from(place.at > 0.0)];
        place.point.active_set = ActiveSet::new(end, &context.domain);
    }
    let knee = knee_at.and_then(|at| {
        points
            .iter()
            .position(|point| (point.at - at).abs() <= 2.0 * LOCATED)
    });
    Ok(Front {
        points: points.into_iter().map(|place| place.point).collect(),
        knee,
        relative_bulge: 0.5 * (1.0 - smallest_sum),
        dominated,
        ended,
        interrupted,
    })
}

/// Traces the front from the first end. If the trace does not reach the second end, the front is
/// also traced from the second end.
fn trace_from_both_ends(
    plane: &FrontPlane<'_>,
    first: Compromise,
    mut second: Compromise,
) -> TracedPath {
    let context = plane.context;
    let mut path = trace(plane, first, 1.0);
    let reaches_second = path.points.last().is_some_and(|place| {
        context.distance(&place.point.x, &second.point.x) <= TOO_FAR
            && place.at >= 1.0 - END_REACHED
    });
    if reaches_second {
        // replace the last traced point with the minimum of the second function
        second.point.event = path
            .points
            .pop_if(|place| place.at >= 1.0)
            .and_then(|place| place.point.event);
        path.points.push(second);
        path.ended = None;
        return path;
    }
    if context.is_interrupted() {
        return path;
    }
    let mut back = trace(plane, second, -1.0).points;
    back.reverse();
    let is_connected = path
        .points
        .last()
        .zip(back.first())
        .is_some_and(|(last, first)| last.at >= first.at);
    if is_connected {
        path.ended = None;
    }
    path.points = join_branches(path.points, back);
    path
}

/// Joins two branches of a front, and keeps the better branch where they overlap. Points at
/// which a path turns back are removed.
fn join_branches(mut path: Vec<Compromise>, mut back: Vec<Compromise>) -> Vec<Compromise> {
    let (whole_path, whole_back) = (path.clone(), back.clone());
    path.retain(|point| !point.is_turned_back() && !is_worse_than_branch(point, &whole_back));
    back.retain(|point| !point.is_turned_back() && !is_worse_than_branch(point, &whole_path));
    let mut all: Vec<(Compromise, bool)> = path
        .into_iter()
        .map(|point| (point, false))
        .chain(back.into_iter().map(|point| (point, true)))
        .collect();
    all.sort_by(|(a, _), (b, _)| a.at.total_cmp(&b.at));
    let mut previous_branch = None;
    let mut joined = vec![];
    for (mut place, branch) in all {
        if previous_branch.is_some_and(|previous| previous != branch) {
            place.point.event = Some(FrontEvent::Jump);
        }
        previous_branch = Some(branch);
        joined.push(place);
    }
    joined
}

/// True if a compromise is worse than a branch: its sum a + b is larger than the sum on the branch
/// at the same s, which is interpolated linearly.
fn is_worse_than_branch(place: &Compromise, branch: &[Compromise]) -> bool {
    branch
        .windows(2)
        .map(|pair| (&pair[0], &pair[1]))
        .find(|(before, after)| (before.at..=after.at).contains(&place.at))
        .is_some_and(|(before, after)| {
            let part = (place.at - before.at) / (after.at - before.at);
            place.sum > before.sum + part * (after.sum - before.sum) + SAME
        })
}

/// Traces the front from a compromise towards s = `end` (−1 or 1).
fn trace(plane: &FrontPlane<'_>, from: Compromise, end: f64) -> TracedPath {
    let mut points = vec![from];
    let mut step = AdaptiveStep::new(2.0);
    let ended_for = |points, reason: String| TracedPath {
        points,
        ended: Some(reason),
    };
    // s, or −s in a backward trace: it rises from −1 to 1 in both directions
    let travelled = |place: &Compromise| end * place.at;
    while let Some(here) = points.last().cloned()
        && travelled(&here) < 1.0
        && !plane.context.is_interrupted()
    {
        let found = plane.next(&here, end * step.to(travelled(&here), 1.0));
        let (next, distance) = match step.accept_or_halve(found, plane.context.is_interrupted()) {
            Ok(Some(found)) => found,
            Ok(None) => continue,
            Err(error) => return ended_for(points, format!("{NO_COMPROMISE}: {error}")),
        };
        if distance > TOO_FAR {
            // the next point lies on another branch; the trace from the other end follows that
            // branch
            return ended_for(points, NO_COMPROMISE.into());
        }
        step.adapt(distance);
        if next.point.active_set == here.point.active_set {
            points.push(next);
        } else {
            points.extend(locate_event(plane, &here, next, end));
        }
    }
    TracedPath {
        points,
        ended: None,
    }
}

/// Locates the point between two compromises where the active set changes. Returns this point with
/// its event. A trace towards the first function's minimum gets the point twice, once with each of
/// the two active sets.
fn locate_event(
    plane: &FrontPlane<'_>,
    here: &Compromise,
    next: Compromise,
    end: f64,
) -> Vec<Compromise> {
    let travelled = |place: &Compromise| end * place.at;
    let compromise_at = |before: &Compromise, at: f64| Some(plane.next(before, end * at).ok()?.0);
    let mut place = locate_change(
        [here.clone(), next],
        2.0 * LOCATED,
        travelled,
        |before, to| plane.expected_event(before, end * to).map(|at| end * at),
        compromise_at,
        |place| place.point.active_set == here.point.active_set,
    );
    let slope_before = compromise_at(here, travelled(&place) - 4.0 * LOCATED)
        .and_then(|before| before.point.slope);
    // at the end of the front only the slope before the change exists, and the change is no event
    if travelled(&place) >= 1.0 {
        place.point.slope = slope_before;
        return vec![place];
    }
    // where the slopes on the two sides differ, the front has no unique slope
    let differ = |a: f64, b: f64| (a - b).abs() > KINK * a.abs().max(b.abs());
    place.point.slope = place
        .point
        .slope
        .zip(slope_before)
        .filter(|&(after, before)| !differ(after, before))
        .map(|(after, _)| after);
    let changed_from = |before: ActiveSet| Some(FrontEvent::Changed { before });
    if end > 0.0 {
        place.point.event = changed_from(here.point.active_set.clone());
        return vec![place];
    }
    // an event describes the change as seen from the first end: in a backward trace, the active set
    // of `here` begins at this point
    let mut seen_from_first_end = place.clone();
    seen_from_first_end.point.active_set = here.point.active_set.clone();
    seen_from_first_end.point.event = changed_from(place.point.active_set.clone());
    vec![seen_from_first_end, place]
}

/// Computes points at equal distances along a path in the plane of the two functions. Keeps the
/// ends and the events of the path.
fn spread_evenly(plane: &FrontPlane<'_>, path: &[Compromise], count: usize) -> Vec<Compromise> {
    let lengths = path_lengths(path);
    let last = path.len() - 1;
    // keep the ends, the events, and the last point before another branch
    let is_kept = |i: usize| {
        let precedes_jump = path.get(i + 1).is_some_and(Compromise::is_jump);
        i == 0 || i == last || precedes_jump || path[i].point.event.is_some()
    };
    let mut points: Vec<Compromise> = (0..path.len())
        .filter(|i| is_kept(*i))
        .map(|i| path[i].clone())
        .collect();
    for k in 1..count.saturating_sub(1) {
        if plane.context.is_interrupted() {
            break;
        }
        let length = lengths[last] * k as f64 / (count - 1) as f64;
        let after = lengths
            .partition_point(|so_far| *so_far < length)
            .clamp(1, last.max(1));
        let Some([before, behind]) = path.get(after - 1..=after) else {
            continue;
        };
        let part = (length - lengths[after - 1]) / (lengths[after] - lengths[after - 1]);
        let to = before.at + part * (behind.at - before.at);
        // start the corrector at the nearer neighbour; between two branches start it at both, and
        // keep the better result
        let starts = [(before, part <= 0.5), (behind, part > 0.5)];
        let found = starts
            .into_iter()
            .filter(|(_, is_nearer)| *is_nearer || behind.is_jump())
            .filter_map(|(start, _)| plane.next(start, to).ok())
            .map(|(place, _)| place)
            .min_by(|a, b| a.sum.total_cmp(&b.sum));
        points.extend(found);
    }
    points
}

/// Length of the path up to each of its points, in the plane of the two functions.
fn path_lengths(path: &[Compromise]) -> Vec<f64> {
    let in_plane =
        |place: &Compromise| [0.5 * (place.sum + place.at), 0.5 * (place.sum - place.at)];
    let mut lengths = vec![0.0];
    for pair in path.windows(2) {
        let [from, to] = [in_plane(&pair[0]), in_plane(&pair[1])];
        lengths.push(lengths[lengths.len() - 1] + (to[0] - from[0]).hypot(to[1] - from[1]));
    }
    lengths
}

/// Knee of the front, if it has one.
fn find_knee(plane: &FrontPlane<'_>, path: &[Compromise]) -> Option<Compromise> {
    let nearest = path.iter().min_by(|a, b| a.sum.total_cmp(&b.sum))?;
    if nearest.at.abs() >= 1.0 || 0.5 * (1.0 - nearest.sum) < STRAIGHT {
        return None;
    }
    plane
        .knee(nearest)
        .ok()
        .filter(|knee| knee.sum <= nearest.sum + SAME)
        .or_else(|| {
            let mut nearest = nearest.clone();
            nearest.point.event = None;
            Some(nearest)
        })
}

/// Removes duplicates, points that a point of `points` or `path` dominates, and points at which the
/// path turns back, which a neighbour on the path dominates. Also returns the number of dominated
/// points.
fn nondominated(
    points: Vec<Compromise>,
    path: &[Compromise],
    span: [f64; 2],
) -> (Vec<Compromise>, usize) {
    let dominates = |a: &Compromise, b: &Compromise| {
        (0..2).all(|k| a.point.values[k] < b.point.values[k] - SAME * span[k])
    };
    let mut kept: Vec<Compromise> = vec![];
    let mut dominated = 0;
    let mut follows_jump = false;
    for place in &points {
        follows_jump |= place.is_jump();
        let mut others = points.iter().chain(path);
        if place.is_turned_back() || others.any(|other| dominates(other, place)) {
            dominated += 1;
            continue;
        }
        let mut place = place.clone();
        if std::mem::take(&mut follows_jump) {
            place.point.event = Some(FrontEvent::Jump);
        }
        let duplicate = kept
            .last_mut()
            .filter(|last| (last.at - place.at).abs() <= 2.0 * LOCATED);
        match duplicate {
            // of two duplicates at an end of the front, keep the minimum of the function
            Some(last) if place.at >= 1.0 => *last = place,
            Some(last) if place.point.event.is_some() && last.at > -1.0 => *last = place,
            Some(_) => {}
            None => kept.push(place),
        }
    }
    (kept, dominated)
}
