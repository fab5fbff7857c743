use super::*;
use std::arch::wasm32::*;

pack! {
    /// Two numbers (the 128-bit vectors of WebAssembly, which have no fused operation).
    Pack2(v128) of 2 not_inlined plain,
    {
        operators f64x2_add f64x2_sub f64x2_mul f64x2_div,
        spread f64x2_splat, fused |a, b, c| f64x2_add(f64x2_mul(a, b), c), root f64x2_sqrt, least f64x2_min f64x2_max,
        power |k| i64x2_shl(i64x2_add(k, i64x2_splat(1023)), 52),
        below |x, limit| i64x2_bitmask(f64x2_lt(x, limit)),
        select |yes, no, mask| {
            let bit = i64x2(1, 2);
            v128_bitselect(yes, no, i64x2_eq(v128_and(i64x2_splat(i64::from(mask)), bit), bit))
        }
    }
}
