//! Curves with as few points as a drawing needs.

/// Maximum distance between an omitted point and the simplified curve, pixels. It is below the
/// resolution of the eye, and equal to the resolution of the coordinates in the picture.
const WITHIN: f64 = 0.1;

/// The points of a curve without those that are nearly on the line between their neighbours
/// (Ramer, Douglas and Peucker).
pub(super) fn simplified(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut is_kept = vec![false; points.len()];
    let last = points.len() - 1;
    (is_kept[0], is_kept[last]) = (true, true);
    let mut parts = vec![[0, last]];
    while let Some([from, to]) = parts.pop() {
        let ends = [points[from], points[to]];
        let off = (from + 1..to).map(|i| (i, distance(points[i], ends)));
        let Some((farthest, most)) = off.max_by(|a, b| a.1.total_cmp(&b.1)) else {
            continue;
        };
        if most > WITHIN {
            is_kept[farthest] = true;
            parts.extend([[from, farthest], [farthest, to]]);
        }
    }
    let kept = points.iter().zip(is_kept).filter(|(_, is_kept)| *is_kept);
    kept.map(|(at, _)| *at).collect()
}

/// The distance of a point from a segment.
fn distance(at: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let [x, y] = [at[0] - from[0], at[1] - from[1]];
    let square = dx * dx + dy * dy;
    let part = if square > 0.0 {
        ((x * dx + y * dy) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (x - part * dx).hypot(y - part * dy)
}

#[cfg(test)]
mod tests {
    use super::{WITHIN, distance, simplified};

    #[test]
    fn a_simplified_circle_is_near_every_point_and_has_few() {
        let circle: Vec<[f64; 2]> = (0..=1000)
            .map(|i| f64::from(i) * std::f64::consts::TAU / 1000.0)
            .map(|at| [50.0 * at.cos(), 50.0 * at.sin()])
            .collect();
        let few = simplified(&circle);
        assert!((20..120).contains(&few.len()), "{}", few.len());
        assert_eq!((few.first(), few.last()), (circle.first(), circle.last()));
        for at in &circle {
            let nearest = few
                .windows(2)
                .map(|ends| distance(*at, [ends[0], ends[1]]))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest <= WITHIN, "{at:?}: {nearest}");
        }
        assert_eq!(simplified(&[[1.0, 2.0]; 4]), [[1.0, 2.0]; 2]);
    }
}
