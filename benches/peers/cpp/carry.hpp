// What every C++ peer with automatic differentiation computes: the carry of the mae494 drive in a
// vertical plane. The template parameters are number types. T: type of differentiated variables; C:
// type of the other parameters (double for T1-T3, T for T4). x is up, z is downrange. RK4
// integrates velocities and positions in steps of 0.01 s. Newton's method finds the landing on the
// quintic Hermite polynomial of the last step. longdrive has degree 7; at this step both give the
// same carry to 1e-12 m.
#pragma once
#include <cmath>
static inline double tovalue(double x) { return x; }

template <class C> struct Const {
  C M{0.230}, m{0.049}, R{0.021336}, Ib{5.85e-6}, d{0.037}, Iyy{3.77e-4}, e{0.7}, V{44.7}, rho{1.225}, delta{0.7};
};
constexpr double G = 9.81, DT = 0.01;

template <class T, class C> struct Launch { T vx, vz, w0; C kq; };

template <class T, class C> Launch<T, C> impact(const T& lam, const T& eps, const Const<C>& p) {
  using std::sin; using std::cos;
  T sl = sin(lam), cl = cos(lam);
  T bn = (1.0 + p.e) * p.V * p.M / (p.M + p.m) * cl;
  T J = p.V / (1.0 / p.m + p.R * p.R / p.Ib + 1.0 / p.M + p.d * p.d / p.Iyy) * sl;
  T bt = J / p.m, w0 = J * (p.R / p.Ib), th = lam + eps;
  T s = sin(th), c = cos(th);
  return {bn * s - bt * c, bn * c + bt * s, w0, 0.5 * M_PI * p.rho * p.R * p.R / p.m};
}

template <class T, class C> T flight(T vx, T vz, const T& w0, const C& kq, const C& delta, int* steps = nullptr) {
  using std::exp; using std::sqrt;
  const double h = DT, h2 = 0.5 * DT, h6 = DT / 6, hh6 = DT * DT / 6;
  auto node = [&](double t, T& cd, T& cl) {
    T w = w0 * exp(-delta * t);
    cd = 0.3 + 2.58e-4 * w;
    cl = 0.319 * (1.0 - exp(-2.48e-3 * w));
  };
  auto rhs = [&](const T& cd, const T& cl, const T& ux, const T& uz, T& ax, T& az) {
    T q = kq * sqrt(ux * ux + uz * uz);
    ax = q * (cl * uz - cd * ux) - G;
    az = -(q * (cd * uz + cl * ux));
  };
  T x = 0.0 * w0, z = 0.0 * w0, cd0, cl0, cdm, clm, a1x, a1z, a2x, a2z, a3x, a3z, a4x, a4z;
  node(0.0, cd0, cl0);
  rhs(cd0, cl0, vx, vz, a1x, a1z);
  for (int n = 0; n < 4000; ++n) {
    double t = n * DT;
    node(t + h2, cdm, clm);
    node(t + h, cd0, cl0);
    rhs(cdm, clm, vx + h2 * a1x, vz + h2 * a1z, a2x, a2z);
    rhs(cdm, clm, vx + h2 * a2x, vz + h2 * a2z, a3x, a3z);
    rhs(cd0, cl0, vx + h * a3x, vz + h * a3z, a4x, a4z);
    T x1 = x + h * vx + hh6 * (a1x + a2x + a3x), z1 = z + h * vz + hh6 * (a1z + a2z + a3z);
    T vx1 = vx + h6 * (a1x + 2.0 * (a2x + a3x) + a4x), vz1 = vz + h6 * (a1z + 2.0 * (a2z + a3z) + a4z);
    T b1x, b1z;
    rhs(cd0, cl0, vx1, vz1, b1x, b1z);  // acceleration at the new node (= k1 of the next step)
    if (tovalue(x1) <= 0) {
      if (steps) *steps = n + 1;
      // launched down, and not lifted above the ground within the first step
      if (n == 0 && tovalue(vx) <= 0) return 0.0 * w0;
      // quintic Hermite, Newton from the end of the step
      auto coef = [&](const T& p0, const T& v0, const T& a0, const T& p1, const T& v1, const T& a1, T c[6]) {
        T dp = p1 - p0, V0 = h * v0, V1 = h * v1, A0 = h * h * a0, A1 = h * h * a1;
        c[0] = p0; c[1] = V0; c[2] = 0.5 * A0;
        c[3] = 10.0 * dp - 6.0 * V0 - 4.0 * V1 - 0.5 * (3.0 * A0 - A1);
        c[4] = 7.0 * V1 + 8.0 * V0 - 15.0 * dp + 0.5 * (3.0 * A0 - 2.0 * A1);
        c[5] = 6.0 * dp - 3.0 * V0 - 3.0 * V1 - 0.5 * (A0 - A1);
      };
      T c[6], b[6];
      coef(x, vx, a1x, x1, vx1, b1x, c);
      coef(z, vz, a1z, z1, vz1, b1z, b);
      T s = 0.0 * w0 + 1.0;
      for (int i = 0; i < 8; ++i) {
        T f = ((((c[5] * s + c[4]) * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0];
        T g = (((5.0 * c[5] * s + 4.0 * c[4]) * s + 3.0 * c[3]) * s + 2.0 * c[2]) * s + c[1];
        s = s - f / g;
      }
      return ((((b[5] * s + b[4]) * s + b[3]) * s + b[2]) * s + b[1]) * s + b[0];
    }
    x = x1; z = z1; vx = vx1; vz = vz1; a1x = b1x; a1z = b1z;
  }
  return z;
}

template <class T, class C> T carry(const T& lam, const T& eps, const Const<C>& p, int* steps = nullptr) {
  auto l = impact<T, C>(lam, eps, p);
  return flight<T, C>(l.vx, l.vz, l.w0, l.kq, p.delta, steps);
}

