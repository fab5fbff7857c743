//! Scrambled Sobol sequence (Owen 1995; Burley 2020): low-discrepancy points of the unit cube.

/// Maximum number of variables.
pub(crate) const MOST_VARIABLES: usize = sobol_burley::NUM_DIMENSIONS as usize;

/// Number of points of one scrambling.
pub(crate) const LENGTH: u64 = 1 << 16;

/// Coordinate of a point, in [0, 1). After each 65 536 points the sequence continues with another
/// scrambling; the points of each such block are evenly distributed.
pub(crate) fn coordinate(point: u64, variable: usize, seed: u32) -> f64 {
    let scrambling = seed.wrapping_add((point / LENGTH) as u32);
    f64::from(sobol_burley::sample(
        (point % LENGTH) as u32,
        variable as u32,
        scrambling,
    ))
}

#[cfg(test)]
mod tests {
    use super::coordinate;

    #[test]
    fn exact_each_block_of_the_sequence_has_one_point_in_each_cell() {
        for stretch in [0_u64, 1 << 16, 3 << 16] {
            let mut seen = [[0; 16]; 16];
            for point in stretch..stretch + 256 {
                let cell = |variable| (16.0 * coordinate(point, variable, 7)) as usize;
                seen[cell(0)][cell(1)] += 1;
            }
            assert_eq!(seen, [[1; 16]; 16]);
        }
    }
}
