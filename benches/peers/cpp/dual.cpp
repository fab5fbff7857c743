// Hand-written dual numbers, a struct of a value and its tangents: in practice the fastest
// automatic differentiation.
#include "dual.hpp"
#include "carry.hpp"
#include "harness.hpp"
#include "optimum.hpp"

typedef D<2> D2;
typedef D<12> D12;
static const Const<double> K;

static D2 t2(double l, double e) { return carry<D2, double>(D2(l, 0), D2(e, 1), K); }
static H2 t3(double l, double e) { return carry<H2, double>(H2(l, 1, 0, 0, 0, 0), H2(e, 0, 1, 0, 0, 0), K); }
static D12 t4(double l, double e) {
  Const<D12> k;
  D12* f[10] = {&k.M, &k.m, &k.R, &k.Ib, &k.d, &k.Iyy, &k.e, &k.V, &k.rho, &k.delta};
  for (int i = 0; i < 10; ++i) f[i]->d[i + 2] = 1;
  return carry<D12, D12>(D12(l, 0), D12(e, 1), k);
}

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  int steps;
  carry<double, double>(LAM0, EPS0, K, &steps);
  bench.task("T1", [](double l, double e) { return carry<double, double>(l, e, K); },
             [&](double v) { return Row{v, {}, std::to_string(steps) + " steps"}; });
  bench.task("T2", t2, [](const D2& r) { return Row{r.v, {r.d[0], r.d[1]}, ""}; });
  bench.task("T3", t3, [](const H2& r) { return Row{r.v, {r.a, r.b, r.aa, r.ab, r.bb}, ""}; });
  bench.task("T4", t4, [](const D12& r) { return Row{r.v, std::vector<double>(r.d, r.d + 12), ""}; });
  auto vgh = [](double l, double e) { H2 r = t3(l, e); return VGH{r.v, {r.a, r.b}, {r.aa, r.ab, r.bb}}; };
  bench.task("T5", [&](double l, double e) { return maximise(vgh, l, e); }, shown);
  bench.grid(25, [](double lam, int first, int stride, auto add) {
    for (int j = first; j < 1000; j += stride) { D2 r = t2(lam, Bench::attack(j)); add(j, r.v, r.d[0], r.d[1]); }
  });
}
