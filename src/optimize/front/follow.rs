//! The front from one end to the other, and points spread evenly over it.

use super::context::{FrontContext, PART_MISSING, SAME, STRAIGHT, given_up};
use super::found::{Front, FrontEvent, FrontPoint};
use super::places::{Place, Plane};
use crate::error::Result;
use crate::optimize::continuation::{Stride, TOO_FAR, located};
use crate::optimize::sensitivity::Held;
use crate::optimize::solution::Solution;

/// Events are located to this part of s.
const LOCATED: f64 = 1e-9;

/// Slopes that differ by this part on the two sides of a place make a corner of the front.
const CORNER: f64 = 1e-3;

/// A place with what happens there.
type Met = (Place, Option<FrontEvent>);

/// The front between the minima of the two functions.
pub(super) fn followed(
    context: &FrontContext<'_>,
    ends: [Solution; 2],
    values: [[f64; 2]; 2],
    count: usize,
) -> Result<Front> {
    let zero = std::array::from_fn(|k| values[k][k]);
    let span = std::array::from_fn(|k| given_up(values, k));
    let plane = Plane {
        context,
        zero,
        span,
    };
    let [first, second] = ends;
    let held_at_ends = [plane.held(&first), plane.held(&second)];
    let [first, second] = [
        plane.end(0, first, values[0]),
        plane.end(1, second, values[1]),
    ];

    let (path, mut ended) = paths(&plane, first, second);
    let mut points = spread(&plane, &path, count);
    // where it was stopped on the way, what was found there is the answer
    let mut interrupted = context.is_interrupted();
    if interrupted && points.len() < 3 {
        points.clone_from(&path);
    }
    let knee = if interrupted {
        None
    } else {
        knee(&plane, &path)
    };
    interrupted = interrupted || context.is_interrupted();
    if interrupted {
        ended = Some(PART_MISSING.into());
    }
    let bend = path
        .iter()
        .map(|(place, _)| place.sum)
        .chain(knee.iter().map(|knee| knee.sum))
        .fold(1.0, f64::min);
    let knee_at = knee.as_ref().map(|knee| knee.at);
    points.extend(knee.map(|knee| (knee, None)));
    points.sort_by(|(a, _), (b, _)| a.at.total_cmp(&b.at));
    let (points, dominated) = best(points, &path, span);
    let at = |at: f64| {
        points
            .iter()
            .position(|(place, _)| (place.at - at).abs() <= 2.0 * LOCATED)
    };
    let knee = knee_at.and_then(at);
    let points = points
        .into_iter()
        .map(|met| told(met, &held_at_ends))
        .collect();
    Ok(Front {
        points,
        knee,
        bend: 0.5 * (1.0 - bend),
        dominated,
        ended,
        interrupted,
    })
}

/// What is told of a place. What holds an end is what holds it in the search for its own function:
/// as a compromise its multipliers vanish.
fn told((place, event): Met, held_at_ends: &[Held; 2]) -> FrontPoint {
    let Place {
        at,
        x,
        values,
        slope,
        rates,
        held,
        ..
    } = place;
    let held = match at {
        _ if at <= -1.0 => held_at_ends[0].clone(),
        _ if at >= 1.0 => held_at_ends[1].clone(),
        _ => held,
    };
    FrontPoint {
        x,
        values,
        slope,
        rates,
        held,
        event,
    }
}

/// The front from the first end, and where that does not lead to the second, also from there; why a
/// part is missing, if it is.
fn paths(plane: &Plane<'_>, first: Place, second: Place) -> (Vec<Met>, Option<String>) {
    let context = plane.context;
    let (mut path, mut why) = along(plane, first, 1.0);
    let is_there = |place: &Place| context.apart(&place.x, &second.x) <= TOO_FAR;
    if path
        .last()
        .is_some_and(|(place, _)| is_there(place) && place.at >= 1.0 - STRAIGHT)
    {
        // the end is known from its own search
        let event = path
            .pop_if(|(place, _)| place.at >= 1.0)
            .and_then(|(_, event)| event);
        path.push((second, event));
        return (path, None);
    }
    if context.is_interrupted() {
        return (path, why);
    }
    let (mut back, _) = along(plane, second, -1.0);
    back.reverse();
    if path
        .last()
        .zip(back.first())
        .is_some_and(|(last, first)| last.0.at >= first.0.at)
    {
        why = None;
    }
    (joined(path, back), why)
}

/// Two parts of a front that need not be connected: of both, what is better.
fn joined(mut path: Vec<Met>, mut back: Vec<Met>) -> Vec<Met> {
    let is_worse = |place: &Place, others: &[Met]| {
        let beside = others
            .windows(2)
            .find(|pair| (pair[0].0.at..=pair[1].0.at).contains(&place.at));
        beside.is_some_and(|pair| {
            let part = (place.at - pair[0].0.at) / (pair[1].0.at - pair[0].0.at);
            place.sum > pair[0].0.sum + part * (pair[1].0.sum - pair[0].0.sum) + SAME
        })
    };
    let whole = (path.clone(), back.clone());
    path.retain(|(place, _)| !is_worse(place, &whole.1));
    back.retain(|(place, _)| !is_worse(place, &whole.0));
    let is_of_back =
        std::iter::repeat_n(false, path.len()).chain(std::iter::repeat_n(true, back.len()));
    let mut all: Vec<(Met, bool)> = path.into_iter().chain(back).zip(is_of_back).collect();
    all.sort_by(|((a, _), _), ((b, _), _)| a.at.total_cmp(&b.at));
    let sides: Vec<bool> = all.iter().map(|(_, side)| *side).collect();
    let met = |(k, ((place, event), side)): (usize, (Met, bool))| {
        let is_other = k > 0 && sides[k - 1] != side;
        (
            place,
            if is_other {
                Some(FrontEvent::Jump)
            } else {
                event
            },
        )
    };
    all.into_iter().enumerate().map(met).collect()
}

/// Follows the front from a place towards where s is `end`, −1 or 1; why it ends before, if it
/// does.
fn along(plane: &Plane<'_>, from: Place, end: f64) -> (Vec<Met>, Option<String>) {
    let mut path: Vec<Met> = vec![(from, None)];
    let mut stride = Stride::new(2.0);
    // the way that is gone
    let gone = |place: &Place| end * place.at;
    while let Some((here, _)) = path.last().cloned()
        && gone(&here) < 1.0
        && !plane.context.is_interrupted()
    {
        let (next, apart) = match plane.next(&here, end * stride.to(gone(&here), 1.0)) {
            Ok(found) if found.1 <= TOO_FAR || !stride.halve() => found,
            Ok(_) => continue,
            // an interrupted search is no reason for shorter steps
            Err(_) if plane.context.is_interrupted() => continue,
            Err(_) if stride.halve() => continue,
            Err(error) => {
                return (
                    path,
                    Some(format!(
                        "no compromise was found in a part of the front: {error}"
                    )),
                );
            }
        };
        if apart > TOO_FAR {
            // another branch, which the other end leads to
            return (
                path,
                Some("no compromise was found in a part of the front".into()),
            );
        }
        stride.adapt(apart);
        let mut met = (next, None);
        if met.0.held != here.held {
            let step = |before: &Place, at: f64| Some(plane.next(before, end * at).ok()?.0);
            let expected =
                |before: &Place, to: f64| plane.expected(before, end * to).map(|at| end * at);
            let is_as_before = |place: &Place| place.held == here.held;
            let both = [here.clone(), met.0];
            let mut place = located(both, 2.0 * LOCATED, gone, expected, step, is_as_before);
            // a corner of the front has no one slope
            let before = step(&here, gone(&place) - 4.0 * LOCATED).and_then(|before| before.slope);
            let differ = |[a, b]: [f64; 2]| (a - b).abs() > CORNER * a.abs().max(b.abs());
            place.slope = place
                .slope
                .zip(before)
                .filter(|&(a, b)| !differ([a, b]))
                .map(|(slope, _)| slope);
            let before = here.held.clone();
            if end > 0.0 {
                met = (place, Some(FrontEvent::Changed { before }));
            } else {
                // seen from the first end, what holds behind this place begins here
                let seen = Place {
                    held: before,
                    ..place.clone()
                };
                path.push((
                    seen,
                    Some(FrontEvent::Changed {
                        before: place.held.clone(),
                    }),
                ));
                met = (place, None);
            }
        }
        path.push(met);
    }
    (path, None)
}

/// Points at even distances along a path in the plane of the two functions, with its ends and its
/// events.
fn spread(plane: &Plane<'_>, path: &[Met], count: usize) -> Vec<Met> {
    let in_plane = |place: &Place| [0.5 * (place.sum + place.at), 0.5 * (place.sum - place.at)];
    let mut lengths = vec![0.0];
    for pair in path.windows(2) {
        let [from, to] = [in_plane(&pair[0].0), in_plane(&pair[1].0)];
        lengths.push(lengths[lengths.len() - 1] + (to[0] - from[0]).hypot(to[1] - from[1]));
    }
    let whole = lengths[lengths.len() - 1];
    let last = path.len() - 1;
    // the ends, the events, and the last point before another branch
    let is_kept = |i: usize| {
        let is_jump = path
            .get(i + 1)
            .is_some_and(|(_, event)| *event == Some(FrontEvent::Jump));
        i == 0 || i == last || is_jump || path[i].1.is_some()
    };
    let mut points: Vec<Met> = (0..path.len())
        .filter(|i| is_kept(*i))
        .map(|i| path[i].clone())
        .collect();
    for k in 1..count.saturating_sub(1) {
        if plane.context.is_interrupted() {
            break;
        }
        let length = whole * k as f64 / (count - 1) as f64;
        let after = lengths
            .partition_point(|so_far| *so_far < length)
            .clamp(1, last.max(1));
        let Some([(before, _), (behind, _)]) = path.get(after - 1..=after) else {
            continue;
        };
        let part = (length - lengths[after - 1]) / (lengths[after] - lengths[after - 1]);
        let to = before.at + part * (behind.at - before.at);
        // from the nearer of its neighbours, and from both where these are not connected
        let is_gap = path[after].1 == Some(FrontEvent::Jump);
        let near = [before, behind].into_iter().zip([part <= 0.5, part > 0.5]);
        let found = near
            .filter(|(_, is_nearer)| *is_nearer || is_gap)
            .filter_map(|(near, _)| plane.next(near, to).ok());
        let found = found
            .map(|(place, _)| place)
            .min_by(|a, b| a.sum.total_cmp(&b.sum));
        points.extend(found.map(|place| (place, None)));
    }
    points
}

/// The knee, where there is one.
fn knee(plane: &Plane<'_>, path: &[Met]) -> Option<Place> {
    let nearest = path
        .iter()
        .map(|(place, _)| place)
        .min_by(|a, b| a.sum.total_cmp(&b.sum))?;
    if nearest.at.abs() >= 1.0 || 0.5 * (1.0 - nearest.sum) < STRAIGHT {
        return None;
    }
    plane
        .knee(nearest)
        .ok()
        .filter(|knee| knee.sum <= nearest.sum + SAME)
        .or_else(|| Some(nearest.clone()))
}

/// Without the points that another is better than in both functions, of these and of the path, and
/// without one that stands there twice; how many the former are.
fn best(points: Vec<Met>, path: &[Met], span: [f64; 2]) -> (Vec<Met>, usize) {
    let is_better =
        |a: &Place, b: &Place| (0..2).all(|k| a.values[k] < b.values[k] - SAME * span[k]);
    let (mut once, mut dominated, mut is_jump): (Vec<Met>, usize, bool) = (vec![], 0, false);
    for (place, event) in &points {
        is_jump |= *event == Some(FrontEvent::Jump);
        if points
            .iter()
            .chain(path)
            .any(|(other, _)| is_better(other, place))
        {
            dominated += 1;
            continue;
        }
        let event = if std::mem::take(&mut is_jump) {
            Some(FrontEvent::Jump)
        } else {
            event.clone()
        };
        let met = (place.clone(), event);
        match once
            .last_mut()
            .filter(|last| (last.0.at - met.0.at).abs() <= 2.0 * LOCATED)
        {
            // of an end what its own search found
            Some(last) if met.0.at >= 1.0 => *last = met,
            Some(last) if met.1.is_some() && last.0.at > -1.0 => *last = met,
            Some(_) => {}
            None => once.push(met),
        }
    }
    (once, dominated)
}
