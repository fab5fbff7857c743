//! Hatching of regions.

use crate::statistics::extent;

/// Hatches the area inside some rings (even-odd rule) with segments of lines x + y = c, at a
/// distance `apart`. All regions of a picture have lines with the same values of c, so that their
/// hatchings are aligned.
pub(super) fn hatching(rings: &[Vec<[f64; 2]>], apart: f64) -> Vec<[[f64; 2]; 2]> {
    let [low, high] = extent(rings.iter().flatten().map(|[x, y]| x + y));
    // two lines x + y = c have the distance |Δc|/√2
    let step = apart * std::f64::consts::SQRT_2;
    if !(low < high && step > 0.0) {
        return vec![];
    }
    let lines = (low / step).ceil() as i64..=(high / step).floor() as i64;
    lines
        .flat_map(|line| within(rings, line as f64 * step))
        .collect()
}

/// The segments of the line x + y = sum inside some rings.
fn within(rings: &[Vec<[f64; 2]>], sum: f64) -> Vec<[[f64; 2]; 2]> {
    let edges = rings
        .iter()
        .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let mut crossings: Vec<[f64; 2]> = edges
        .filter_map(|(a, b)| {
            let [from, to] = [a, b].map(|[x, y]| x + y - sum);
            let part = from / (from - to);
            ((from < 0.0) != (to < 0.0))
                .then(|| [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])])
        })
        .collect();
    crossings.sort_by(|a, b| a[0].total_cmp(&b[0]));
    crossings
        .chunks_exact(2)
        .map(|pair| [pair[0], pair[1]])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::hatching;

    /// The area of a shape is the total length of its hatching lines times the distance between
    /// them.
    #[test]
    fn hatching_fills_a_ring_and_leaves_its_hole() {
        let square = |from: f64, to: f64| vec![[from, from], [to, from], [to, to], [from, to]];
        let apart = 0.01;
        for (rings, area) in [
            (vec![square(0.0, 10.0)], 100.0),
            (vec![square(0.0, 10.0), square(4.0, 6.0)], 96.0),
        ] {
            let lines = hatching(&rings, apart);
            let length: f64 = lines
                .iter()
                .map(|[a, b]| (b[0] - a[0]).hypot(b[1] - a[1]))
                .sum();
            assert!((length * apart - area).abs() < 0.2, "{}", length * apart);
            let in_hole = |[x, y]: &[f64; 2]| {
                rings.len() > 1 && [x, y].iter().all(|at| (4.01..5.99).contains(*at))
            };
            let middles = lines
                .iter()
                .map(|[a, b]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
            assert!(middles.filter(in_hole).count() == 0);
        }
        assert!(hatching(&[], 1.0).is_empty() && hatching(&[vec![[1.0, 1.0]]], 1.0).is_empty());
    }
}
