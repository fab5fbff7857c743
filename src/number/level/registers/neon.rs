use super::*;
use std::arch::aarch64::*;

pack! {
    /// Two numbers (NEON, which every processor of the architecture has).
    Pack2(float64x2_t) of 2 not_inlined plain,
    {
        operators vaddq_f64 vsubq_f64 vmulq_f64 vdivq_f64,
        spread vdupq_n_f64, fused |a, b, c| vfmaq_f64(c, a, b), root vsqrtq_f64, least vminq_f64 vmaxq_f64,
        power |k| vreinterpretq_f64_s64(vshlq_n_s64::<52>(vaddq_s64(vreinterpretq_s64_f64(k), vdupq_n_s64(1023)))),
        below |x, limit| {
            let holds = vcltq_f64(x, limit);
            vgetq_lane_u64::<0>(holds) & 1 | vgetq_lane_u64::<1>(holds) & 2
        },
        select |yes, no, mask| {
            let bit = vcombine_u64(vcreate_u64(1), vcreate_u64(2));
            vbslq_f64(vtstq_u64(vdupq_n_u64(u64::from(mask)), bit), yes, no)
        }
    }
}
