// Derivatives worked out by hand. The scalar program does T1, T2 and T6. With -DVEC=v4, -DVEC=v8,
// or -DTWO_VECTORS -DVEC=V2, the lanes of a vector are attack angles, and the program does T6 only.
#include "tuned.hpp"
#include "harness.hpp"
#ifdef TWO_VECTORS
#include "two_vectors.hpp"
#endif
#ifndef VEC
#define VEC double
#endif
typedef VEC V;

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  const int W = L<V>::n;
  if constexpr (W == 1) {
    bench.task("T1", [](double l, double e) { return tuned<double, false>(l, e); },
               [](auto& r) { return Row{r.c, {}, std::to_string(r.steps) + " steps"}; });
    bench.task("T2", [](double l, double e) { return tuned<double, true>(l, e); }, [](auto& r) { return Row{r.c, {r.dl, r.de}, ""}; });
  }
  bench.grid(W == 1 ? 25 : 1, [](double lam, int first, int stride, auto add) {
    if constexpr (W == 1) {
      for (int j = first; j < 1000; j += stride) { auto r = tuned<double, true>(lam, Bench::attack(j)); add(j, r.c, r.dl, r.de); }
    } else {
      for (int j = first; j < 1000; j += W) {
        V e; for (int k = 0; k < W; ++k) ((double*)&e)[k] = Bench::attack(j + k);
        auto r = tuned<V, true>(L<V>::set(lam), e); keep(r);
        for (int k = 0; k < W && j + k < 1000; ++k) add(j + k, ((double*)&r.c)[k], ((double*)&r.dl)[k], ((double*)&r.de)[k]);
      }
    }
  });
}
