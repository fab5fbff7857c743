use super::*;
use std::arch::x86_64::*;

pack! {
    /// Four numbers (AVX2 with FMA).
    Pack4(__m256d) of 4 not_inlined avx2,
    {
        operators _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd,
        spread _mm256_set1_pd, fused |a, b, c| _mm256_fmadd_pd(a, b, c), root _mm256_sqrt_pd, least _mm256_min_pd _mm256_max_pd,
        power |k| _mm256_castsi256_pd(
            _mm256_slli_epi64::<52>(_mm256_add_epi64(_mm256_castpd_si256(k), _mm256_set1_epi64x(1023)))
        ),
        below |x, limit| _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(x, limit)),
        select |yes, no, mask| {
            let bit = _mm256_set_epi64x(8, 4, 2, 1);
            let set = _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(i64::from(mask)), bit), bit);
            _mm256_blendv_pd(no, yes, _mm256_castsi256_pd(set))
        }
    }
}

pack! {
    /// Eight numbers (AVX-512).
    Pack8(__m512d) of 8 not_inlined avx512,
    {
        operators _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd,
        spread _mm512_set1_pd, fused |a, b, c| _mm512_fmadd_pd(a, b, c), root _mm512_sqrt_pd, least _mm512_min_pd _mm512_max_pd,
        power |k| _mm512_castsi512_pd(
            _mm512_slli_epi64::<52>(_mm512_add_epi64(_mm512_castpd_si512(k), _mm512_set1_epi64(1023)))
        ),
        below |x, limit| _mm512_cmp_pd_mask::<_CMP_LT_OQ>(x, limit),
        select |yes, no, mask| _mm512_mask_blend_pd(mask, no, yes),
        root and inverse |x| {
            // for x > 0 (NaN at 0): an instruction gives 1/√x to 14 bits; one iteration of fourth
            // order gives 70 bits, and halves the rounding error of `first`
            let guess = Self(unsafe { _mm512_rsqrt14_pd(x.0) });
            let first = x * guess;
            let error = -first.mul_add(guess, Self::constant(-1.0));
            let high = error.scale_add(35.0 / 128.0, Self::constant(0.3125));
            let series = high.mul_add(error * error, error.scale_add(0.375, Self::constant(0.5)));
            ((first * error).mul_add(series, first), (guess * error).mul_add(series, guess))
        }
    }
}
