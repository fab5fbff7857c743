// Measures the clock rate with a chain of dependent multiplications, each of 3 cycles. Then
// measures, in cycles, what bounds the tasks from below: the latencies of sqrtsd and of a fused
// multiply-add; with AVX-512 also the time between two independent vsqrtpd of 8 lanes.
#include <immintrin.h>
#include <stdio.h>
#include <time.h>
static double now() { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }
// rate, 1/s, of n operations, in the fastest of 300 runs
#define RATE(n, ...) ({ double best = 1e9; for (int r = 0; r < 300; r++) { double a = now(); __VA_ARGS__; double d = now() - a; if (d < best) best = d; } (n) / best; })
int main() {
  const long N = 200000;
  double clock = 3 * RATE(N, { long x = 0; for (long i = 0; i < N; i += 10) { __asm__ volatile("imul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\nimul %0,%0\n" : "+r"(x)); } });
  printf("{\"clock_GHz\":%.3f", clock / 1e9);
#ifdef __FMA__
  double sqrt = RATE(N / 10, { __m128d a = _mm_set_sd(3); for (long i = 0; i < N / 10; i++) { a = _mm_sqrt_sd(a, a); __asm__ volatile("" : "+x"(a)); } });
  double fma = RATE(N / 10, { __m128d a = _mm_set_sd(3), c = a; for (long i = 0; i < N / 10; i++) { a = _mm_fmadd_sd(a, c, c); __asm__ volatile("" : "+x"(a)); } });
  printf(",\"sqrtsd_cycles\":%.1f,\"fma_cycles\":%.1f", clock / sqrt, clock / fma);
#endif
#ifdef __AVX512F__
  double wide = RATE(N / 100 * 8, { __m512d a[8]; for (int i = 0; i < 8; i++) a[i] = _mm512_set1_pd(3); for (long i = 0; i < N / 100; i++) {
    _Pragma("GCC unroll 8") for (int k = 0; k < 8; k++) { a[k] = _mm512_sqrt_pd(a[k]); __asm__ volatile("" : "+v"(a[k])); } } });
  printf(",\"vsqrtpd8_cycles\":%.1f", clock / wide);
#endif
  printf("}\n");
}
