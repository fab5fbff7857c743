// T4 by the chain rule. The flight depends on the twelve parameters only through vx, vz and w0 at
// launch, kq and delta. It therefore has 5 tangents, in one vector of 8 lanes. The impact has dual
// numbers with 12 tangents.
#include "dual.hpp"
typedef double W8 __attribute__((vector_size(64)));
struct DV { double v; W8 d; DV() {} DV(double x) : v(x), d{} {} DV(double x, W8 d) : v(x), d(d) {} };
inline DV operator+(DV a, DV b) { return {a.v + b.v, a.d + b.d}; } inline DV operator-(DV a, DV b) { return {a.v - b.v, a.d - b.d}; }
inline DV operator*(DV a, DV b) { return {a.v * b.v, a.d * b.v + a.v * b.d}; } inline DV operator/(DV a, DV b) { double q = 1 / b.v, r = a.v * q; return {r, (a.d - r * b.d) * q}; }
inline DV operator+(DV a, double b) { return {a.v + b, a.d}; } inline DV operator+(double b, DV a) { return a + b; } inline DV operator-(DV a, double b) { return {a.v - b, a.d}; } inline DV operator-(double b, DV a) { return {b - a.v, -a.d}; }
inline DV operator*(DV a, double b) { return {a.v * b, a.d * b}; } inline DV operator*(double b, DV a) { return a * b; } inline DV operator-(DV a) { return {-a.v, -a.d}; }
inline DV sqrt(DV a) { double s = std::sqrt(a.v); return {s, a.d * (0.5 / s)}; } inline DV exp(DV a) { double s = std::exp(a.v); return {s, a.d * s}; }
inline double tovalue(const DV& a) { return a.v; }
#include "carry.hpp"
#include "harness.hpp"
typedef D<12> D12;
struct Twelve { double v, g[12]; };
static Twelve t4(double l, double e) {
  static const Const<double> K; Const<D12> k; D12* f[10] = {&k.M, &k.m, &k.R, &k.Ib, &k.d, &k.Iyy, &k.e, &k.V, &k.rho, &k.delta};
  for (int i = 0; i < 10; ++i) f[i]->d[i + 2] = 1;
  auto q = impact<D12, D12>(D12(l, 0), D12(e, 1), k);
  DV r = flight<DV, DV>(DV(q.vx.v, W8{1}), DV(q.vz.v, W8{0, 1}), DV(q.w0.v, W8{0, 0, 1}), DV(q.kq.v, W8{0, 0, 0, 1}), DV(K.delta, W8{0, 0, 0, 0, 1}));
  Twelve t; t.v = r.v;
  for (int i = 0; i < 12; ++i) t.g[i] = r.d[0] * q.vx.d[i] + r.d[1] * q.vz.d[i] + r.d[2] * q.w0.d[i] + r.d[3] * q.kq.d[i] + (i == 11 ? r.d[4] : 0);
  return t;
}
int main(int argc, char** argv) {
  Bench bench(argc, argv);
  bench.task("T4", t4, [](const Twelve& t) { return Row{t.v, std::vector<double>(t.g, t.g + 12), ""}; });
}
