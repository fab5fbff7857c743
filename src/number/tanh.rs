use super::{Numbers, inlined};

/// Largest x² at which the polynomial is used. A law that limits the spin ratio by tanh has a
/// smaller x² at usual spin ratios.
const MOST_SQUARED: f64 = 0.5;

/// Polynomial for (tanh(x)/x − 1)/x² in powers of x²: interpolation at the zeros of Chebyshev's
/// polynomial of degree 12 over [0, ½] (computed with 60 digits), error below 1e-17.
const COEFFICIENTS: [f64; 12] = [
    -0.33333333333333326,
    0.13333333333329847,
    -0.053968253964917945,
    0.021869488410785825,
    -0.00886323308732899,
    0.0035920998336879356,
    -0.0014556266937810758,
    0.0005890115556275362,
    -0.00023576697514593936,
    8.938195061319972e-05,
    -2.8040703619543624e-05,
    5.1287079738925226e-06,
];

/// Hyperbolic tangent: a polynomial for small x, an exponential formula without overflow for large
/// x.
#[inline(always)]
pub(super) fn tanh<T: Numbers>(x: T) -> T {
    let square = x * x;
    T::select_lazily(
        square.below(MOST_SQUARED),
        inlined!(|| small(x, square)),
        inlined!(|| large(x)),
    )
}

#[inline(always)]
fn small<T: Numbers>(x: T, y: T) -> T {
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11] = COEFFICIENTS;
    let pair = inlined!(|low: f64, high: f64| y.scale_add(high, T::constant(low)));
    let (y2, x_cubed) = (y * y, x * y);
    let y4 = y2 * y2;
    let low = pair(c2, c3).mul_add(y2, pair(c0, c1));
    let middle = pair(c6, c7).mul_add(y2, pair(c4, c5));
    let high = pair(c10, c11).mul_add(y2, pair(c8, c9));
    high.mul_add(y4, middle)
        .mul_add(y4, low)
        .mul_add(x_cubed, x)
}

#[inline(always)]
fn large<T: Numbers>(x: T) -> T {
    let is_negative = x.below(0.0);
    let size = (-x).select(x, is_negative);
    let decay = (size * -2.0).exp_m1();
    let tanh = -decay / (decay + 2.0);
    (-tanh).select(tanh, is_negative)
}
