// Hand-derived carry + exact gradient (no AD), written once for scalar double and for GCC vectors of 4 / 8 doubles.
//  * spin factor by recurrence, one exp per time node (two per step)
//  * tangents by the closed-form 2x2 Jacobian of the acceleration by the velocity; the tangent by
//    lam has another term, from the spin, which does not depend on eps
//  * landing by quintic Hermite + implicit function theorem
#pragma once
#include <immintrin.h>
#include <cmath>
typedef double v4 __attribute__((vector_size(32)));
typedef double v8 __attribute__((vector_size(64)));
#if defined(__AVX512F__)
extern "C" __m512d _ZGVeN8v_exp(__m512d);
extern "C" __m512d _ZGVeN8v_sin(__m512d);
extern "C" __m512d _ZGVeN8v_cos(__m512d);
#endif
extern "C" __m256d _ZGVdN4v_exp(__m256d);
extern "C" __m256d _ZGVdN4v_sin(__m256d);
extern "C" __m256d _ZGVdN4v_cos(__m256d);
// inline vector exp for |x| < 700 (range reduction by ln2, degree-11 Taylor/minimax; <= 2 ulp on the range used here)
template <class V> static inline V poly_exp_core(V r) {
  V r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  V a = (1.0 + r) + r2 * (0.5 + r * 0.16666666666666666), b = (0.041666666666666664 + r * 0.008333333333333333) + r2 * (0.001388888888888889 + r * 1.984126984126984e-4),
    c = (2.48015873015873e-5 + r * 2.7557319223985893e-6) + r2 * (2.755731922398589e-7 + r * 2.505210838544172e-8);
  return a + (r4 * b + r8 * (c + r4 * 2.08767569878681e-9));
}
static inline v4 exp_inl(v4 x) { v4 k = (v4)_mm256_round_pd((__m256d)(x * 1.4426950408889634), 8); v4 r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
  v4 p = poly_exp_core(r); __m256i e = _mm256_slli_epi64(_mm256_add_epi64(_mm256_castpd_si256((__m256d)(k + 6755399441055744.0)), _mm256_set1_epi64x(1023)), 52); return p * (v4)_mm256_castsi256_pd(e); }
#if defined(__AVX512F__)
static inline v8 exp_inl(v8 x) { v8 k = (v8)_mm512_roundscale_pd((__m512d)(x * 1.4426950408889634), 8); v8 r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
  return (v8)_mm512_scalef_pd((__m512d)poly_exp_core(r), (__m512d)k); }
#endif
template <class V> struct L;  // lane traits
template <> struct L<double> { static constexpr int n = 1;
  static double set(double a) { return a; } static double sqrt(double a) { return std::sqrt(a); } static double exp(double a) { return std::exp(a); }
  static double sin(double a) { return std::sin(a); } static double cos(double a) { return std::cos(a); }
  static void vr(double s, double& v, double& r) { v = std::sqrt(s); r = 1 / v; }
  typedef bool M; static M le0(double a) { return a <= 0; } static bool any(M m) { return m; } static bool all(M m) { return m; }
  static double sel(M m, double a, double b) { return m ? a : b; } };
template <> struct L<v4> { static constexpr int n = 4;
  static v4 set(double a) { return (v4)_mm256_set1_pd(a); } static v4 sqrt(v4 a) { return (v4)_mm256_sqrt_pd((__m256d)a); } static v4 exp(v4 a) {
#ifdef INLEXP
    return exp_inl(a);
#else
    return (v4)_ZGVdN4v_exp((__m256d)a);
#endif
  }
  static v4 sin(v4 a) { return (v4)_ZGVdN4v_sin((__m256d)a); } static v4 cos(v4 a) { return (v4)_ZGVdN4v_cos((__m256d)a); }
  static void vr(v4 s, v4& v, v4& r) {
#if defined(RSQRT) && defined(__AVX512VL__)
    v4 y = (v4)_mm256_rsqrt14_pd((__m256d)s); v4 e = 1.0 - s * y * y; y = y + y * e * (0.5 + e * (0.375 + e * (0.3125 + e * 0.2734375))); r = y; v = s * y;
#else
    v = sqrt(s); r = 1.0 / v;
#endif
  }
  typedef int M; static M le0(v4 a) { return _mm256_movemask_pd(_mm256_cmp_pd((__m256d)a, _mm256_setzero_pd(), _CMP_LE_OQ)); } static bool any(M m) { return m; } static bool all(M m) { return m == 15; }
  static v4 sel(M m, v4 a, v4 b) { for (int i = 0; i < 4; ++i) if (!(m >> i & 1)) a[i] = b[i]; return a; } };
#if defined(__AVX512F__)
template <> struct L<v8> { static constexpr int n = 8;
  static v8 set(double a) { return (v8)_mm512_set1_pd(a); } static v8 sqrt(v8 a) { return (v8)_mm512_sqrt_pd((__m512d)a); } static v8 exp(v8 a) {
#ifdef INLEXP
    return exp_inl(a);
#else
    return (v8)_ZGVeN8v_exp((__m512d)a);
#endif
  }
  static v8 sin(v8 a) { return (v8)_ZGVeN8v_sin((__m512d)a); } static v8 cos(v8 a) { return (v8)_ZGVeN8v_cos((__m512d)a); }
  static void vr(v8 s, v8& v, v8& r) {
#if defined(RSQRT)
    v8 y = (v8)_mm512_rsqrt14_pd((__m512d)s); v8 e = 1.0 - s * y * y; y = y + y * e * (0.5 + e * (0.375 + e * (0.3125 + e * 0.2734375))); r = y; v = s * y;
#else
    v = sqrt(s); r = 1.0 / v;
#endif
  }
  typedef int M; static M le0(v8 a) { return _mm512_cmp_pd_mask((__m512d)a, _mm512_setzero_pd(), _CMP_LE_OQ); } static bool any(M m) { return m; } static bool all(M m) { return m == 255; }
  static v8 sel(M m, v8 a, v8 b) { return (v8)_mm512_mask_blend_pd(m, (__m512d)b, (__m512d)a); } };
#endif

template <class V> struct Res { V c, dl, de; int steps; };
template <class V, bool GRAD> __attribute__((flatten)) static Res<V> tuned(V lam, V eps) {
  typedef L<V> X; typedef typename X::M M;
  constexpr double m = .049, R = .021336, Ib = 5.85e-6, Mh = .23, d = .037, Iyy = 3.77e-4, Vc = 44.7, h = .01, h2 = .005, h6 = .01 / 6, hh6 = 1e-4 / 6, g = 9.81;
  constexpr double A = 1.7 * Vc * Mh / (Mh + m), B = Vc / (1 / m + R * R / Ib + 1 / Mh + d * d / Iyy), kq = 0.5 * 1.225 * M_PI * R * R / m;
  constexpr double kD = 2.58e-4, kL = 2.48e-3;
  const double eh = std::exp(-0.7 * h2);
  V sl = X::sin(lam), cl_ = X::cos(lam), th = lam + eps, s = X::sin(th), c = X::cos(th);
  V bn = A * cl_, J = B * sl, bt = J / m, w0 = J * (R / Ib), dbn = -A * sl, dJ = B * cl_, dbt = dJ / m, dw = dJ * (R / Ib);
  V vx = bn * s - bt * c, vz = bn * c + bt * s;
  V ex = vz, ez = -vx;                                     // d/d eps: pure rotation
  V lx = vz + dbn * s - dbt * c, lz = -vx + dbn * c + dbt * s;
  V zero = X::set(0), x = zero, z = zero, xe = zero, ze = zero, xl = zero, zl = zero;
  M down0 = X::le0(vx);
  struct K { V x, z, ex, ez, lx, lz; };
  struct Nd { V cd, cl, cd1, cl1; };
  V E = X::set(1);
  auto node = [&](V E) { Nd n; V w = w0 * E, y = X::exp(-kL * w); n.cd = kq * 0.3 + (kq * kD) * w; n.cl = (kq * 0.319) - (kq * 0.319) * y;
    if (GRAD) { V f = dw * E; n.cd1 = (kq * kD) * f; n.cl1 = (kq * 0.319 * kL) * (y * f); } return n; };
  auto rhs = [&](const Nd& n, V vx, V vz, V ex, V ez, V lx, V lz) {
    K k; V s = vx * vx + vz * vz, v, r; if (GRAD) X::vr(s, v, r); else v = X::sqrt(s);
    V P = n.cl * vz - n.cd * vx, Q = -(n.cd * vz) - n.cl * vx;
    k.x = v * P - g; k.z = v * Q;
    if (GRAD) {
      V nx = vx * r, nz = vz * r, vd = v * n.cd, vl = v * n.cl;
      V a = P * nx - vd, b = P * nz + vl, cc = Q * nx - vl, dd = Q * nz - vd;
      k.ex = a * ex + b * ez; k.ez = cc * ex + dd * ez;
      V fx = n.cl1 * vz - n.cd1 * vx, fz = n.cd1 * vz + n.cl1 * vx;
      k.lx = a * lx + (b * lz + v * fx); k.lz = cc * lx + (dd * lz - v * fz);
    }
    return k; };
  Nd n0 = node(E), nm; K k1 = rhs(n0, vx, vz, ex, ez, lx, lz), k2, k3, k4, kb;
  M done{}; int n = 0;
  // position, velocity, acceleration and their tangents at both ends of the step that lands
  V S[2][18];
  for (n = 0; n < 4000; ++n) {
    V Em = E * eh; E = Em * eh; nm = node(Em); n0 = node(E);
#define ST(kk, hh) vx + hh * kk.x, vz + hh * kk.z, ex + hh * kk.ex, ez + hh * kk.ez, lx + hh * kk.lx, lz + hh * kk.lz
    if (!GRAD) { k1.ex = k1.ez = k1.lx = k1.lz = k2.ex = k2.ez = k2.lx = k2.lz = k3.ex = k3.ez = k3.lx = k3.lz = zero; }
    k2 = rhs(nm, ST(k1, h2)); if (!GRAD) k2.ex = k2.ez = k2.lx = k2.lz = zero;
    k3 = rhs(nm, ST(k2, h2)); if (!GRAD) k3.ex = k3.ez = k3.lx = k3.lz = zero;
    k4 = rhs(n0, ST(k3, h));
    V x1, z1, xe1, ze1, xl1, zl1, vx1, vz1, ex1, ez1, lx1, lz1;
#define UP(pos, vel, kk, p1, v1) { V t = k2.kk + k3.kk, u = k1.kk + t; p1 = pos + h * vel + hh6 * u; v1 = vel + h6 * ((u + t) + k4.kk); }
    UP(x, vx, x, x1, vx1) UP(z, vz, z, z1, vz1)
    if (GRAD) { UP(xe, ex, ex, xe1, ex1) UP(ze, ez, ez, ze1, ez1) UP(xl, lx, lx, xl1, lx1) UP(zl, lz, lz, zl1, lz1) }
    else { xe1 = ze1 = xl1 = zl1 = ex1 = ez1 = lx1 = lz1 = zero; }
    kb = rhs(n0, vx1, vz1, ex1, ez1, lx1, lz1);
    M hit = X::le0(x1);
    if (__builtin_expect(X::any(hit), 0)) {
      M nw = X::n == 1 ? hit : (M)(hit & ~(int)done);
      if (X::any(nw)) {
        const V a[18] = {x, vx, k1.x, z, vz, k1.z, xe, ex, k1.ex, ze, ez, k1.ez, xl, lx, k1.lx, zl, lz, k1.lz};
        const V b[18] = {x1, vx1, kb.x, z1, vz1, kb.z, xe1, ex1, kb.ex, ze1, ez1, kb.ez, xl1, lx1, kb.lx, zl1, lz1, kb.lz};
        for (int i = 0; i < (GRAD ? 18 : 6); ++i) { S[0][i] = X::sel(nw, a[i], S[0][i]); S[1][i] = X::sel(nw, b[i], S[1][i]); }
        if (n == 0) { M z0 = nw & down0;  // launched into the ground: carry 0, gradient 0
          if (X::any(z0)) { for (int i = 0; i < 18; ++i) S[0][i] = X::sel(z0, zero, S[0][i]), S[1][i] = X::sel(z0, zero, S[1][i]);
            S[0][1] = X::sel(z0, X::set(-1), S[0][1]); S[1][1] = X::sel(z0, X::set(-1), S[1][1]); S[1][0] = X::sel(z0, X::set(-h), S[1][0]); } }
        done = done | nw;
      }
      if (X::all(done)) { ++n; break; }
    }
    x = x1; z = z1; vx = vx1; vz = vz1; k1 = kb;
    if (GRAD) { xe = xe1; ze = ze1; xl = xl1; zl = zl1; ex = ex1; ez = ez1; lx = lx1; lz = lz1; }
  }
  auto coef = [&](int i, V* c) { V p0 = S[0][i], V0 = h * S[0][i + 1], A0 = h * h * S[0][i + 2], V1 = h * S[1][i + 1], A1 = h * h * S[1][i + 2], dp = S[1][i] - p0;
    c[0] = p0; c[1] = V0; c[2] = .5 * A0; c[3] = 10. * dp - 6. * V0 - 4. * V1 - .5 * (3. * A0 - A1); c[4] = 7. * V1 + 8. * V0 - 15. * dp + .5 * (3. * A0 - 2. * A1); c[5] = 6. * dp - 3. * V0 - 3. * V1 - .5 * (A0 - A1); };
#define H5(c, s) (((((c[5] * s + c[4]) * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0])
#define H5D(c, s) ((((5. * c[5] * s + 4. * c[4]) * s + 3. * c[3]) * s + 2. * c[2]) * s + c[1])
  V cx[6], cz[6], q[6], w[6]; coef(0, cx); coef(3, cz);
  V t = X::set(1);
  for (int i = 0; i < 8; ++i) t = t - H5(cx, t) / H5D(cx, t);
  Res<V> r; r.steps = n; r.c = H5(cz, t); r.dl = r.de = zero;
  if (GRAD) { V k = H5D(cz, t) / H5D(cx, t);
    coef(6, q); coef(9, w); r.de = H5(w, t) - k * H5(q, t);
    coef(12, q); coef(15, w); r.dl = H5(w, t) - k * H5(q, t); }
  return r;
}
