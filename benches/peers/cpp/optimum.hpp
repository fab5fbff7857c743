// T5 for the C++ peers: projected Newton method in two variables, with exact Hessian, active set
// and backtracking.
#pragma once
#include <algorithm>
#include <cmath>
#include "harness.hpp"

struct VGH { double v, g[2], h[3]; };
struct Opt { double x[2], v, pg; int evals; };
template <class F> Opt maximise(F f, double l0, double e0) {
  const double lo[2] = {0, -10 * DEG}, hi[2] = {25 * DEG, 10 * DEG};
  double x[2] = {l0, e0}; VGH r = f(x[0], x[1]); int ev = 1; double pg = 0;
  for (int it = 0; it < 60; ++it) {
    bool act[2]; pg = 0;
    for (int i = 0; i < 2; ++i) {
      act[i] = (x[i] <= lo[i] && r.g[i] < 0) || (x[i] >= hi[i] && r.g[i] > 0);
      if (!act[i]) pg = std::max(pg, std::fabs(r.g[i]));
    }
    pg /= r.v;
    if (pg <= 1e-8) break;
    double s[2] = {0, 0}, a = -r.h[0], b = -r.h[1], c = -r.h[2];
    if (act[0]) b = 0, a = 1;
    if (act[1]) b = 0, c = 1;
    // add a multiple of the identity if the Hessian of -f is not positive definite
    double tr = 0.5 * (a + c), dd = std::sqrt(0.25 * (a - c) * (a - c) + b * b), mn = tr - dd;
    double sh = mn < 1e-3 * std::fabs(tr + dd) ? 1e-3 * std::fabs(tr + dd) - mn : 0; a += sh; c += sh;
    double g0 = act[0] ? 0 : r.g[0], g1 = act[1] ? 0 : r.g[1], det = a * c - b * b;
    s[0] = (c * g0 - b * g1) / det; s[1] = (a * g1 - b * g0) / det;
    double t = 1;
    for (int k = 0; k < 30; ++k, t *= 0.5) {
      double y[2]; for (int i = 0; i < 2; ++i) y[i] = std::min(hi[i], std::max(lo[i], x[i] + t * s[i]));
      VGH q = f(y[0], y[1]); ++ev;
      if (q.v > r.v - 1e-13 * r.v) { x[0] = y[0]; x[1] = y[1]; r = q; break; }
    }
  }
  return {{x[0], x[1]}, r.v, pg, ev};
}
static Row shown(const Opt& o) {
  char text[100];
  snprintf(text, sizeof text, "%d evaluations", o.evals);
  return {o.v, {o.x[0] / DEG, o.x[1] / DEG}, text};
}
