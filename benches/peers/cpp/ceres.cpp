// ceres::Jet over the common template; T3 by Jets of Jets.
#include <ceres/jet.h>
namespace ceres {  // nested Jets do not mix with double by themselves
typedef Jet<Jet<double, 2>, 2> JJ_;
#define OP(o) inline JJ_ operator o(const JJ_& a, double b) { return a o JJ_(Jet<double, 2>(b)); } inline JJ_ operator o(double a, const JJ_& b) { return JJ_(Jet<double, 2>(a)) o b; }
OP(+) OP(-) OP(*) OP(/)
}
#include "carry.hpp"
#include "harness.hpp"
#include "optimum.hpp"
using ceres::Jet;
static inline double tv(double x) { return x; }
template <typename T, int N> static inline double tv(const Jet<T, N>& a) { return tv(a.a); }
namespace ceres { template <typename T, int N> inline double tovalue(const Jet<T, N>& a) { return ::tv(a.a); } }
typedef Jet<double, 2> J2; typedef Jet<J2, 2> JJ; typedef Jet<double, 12> J12;
static const Const<double> K;
static J2 t2(double l, double e) { return carry<J2, double>(J2(l, 0), J2(e, 1), K); }
static JJ t3(double l, double e) {
  return carry<JJ, double>(JJ(J2(l, 0), 0), JJ(J2(e, 1), 1), K); }
static J12 t4(double l, double e) { Const<J12> k; J12* f[10] = {&k.M, &k.m, &k.R, &k.Ib, &k.d, &k.Iyy, &k.e, &k.V, &k.rho, &k.delta};
  for (int i = 0; i < 10; ++i) f[i]->v[i + 2] = 1; return carry<J12, J12>(J12(l, 0), J12(e, 1), k); }

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  bench.task("T2", t2, [](const J2& r) { return Row{r.a, {r.v[0], r.v[1]}, ""}; });
  auto vgh = [](double l, double e) { JJ r = t3(l, e); return VGH{r.a.a, {r.v[0].a, r.v[1].a}, {r.v[0].v[0], r.v[0].v[1], r.v[1].v[1]}}; };
  bench.task("T3", vgh, [](const VGH& r) { return Row{r.v, {r.g[0], r.g[1], r.h[0], r.h[1], r.h[2]}, ""}; });
  bench.task("T4", t4, [](const J12& r) { return Row{r.a, std::vector<double>(r.v.data(), r.v.data() + 12), ""}; });
  bench.task("T5", [&](double l, double e) { return maximise(vgh, l, e); }, shown);
  bench.grid(25, [](double lam, int first, int stride, auto add) {
    for (int j = first; j < 1000; j += stride) { J2 r = t2(lam, Bench::attack(j)); add(j, r.a, r.v[0], r.v[1]); }
  });
}
