// Shared by the C++ peers: the command line, timing, the grid of T6, JSON lines.
//
//   PEER             every task, timed
//   PEER T2          one task, timed
//   PEER T2 once     the process does the task once and prints its result
//   PEER T2 count N  does it N times and prints nothing (for instruction counts)
//
// Thread CPU time, the fastest of many batches: on a shared machine, the fastest batch is the least disturbed one.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#ifndef PEER
#error "-DPEER: the peer's name in the table"
#endif

constexpr double DEG = M_PI / 180, LAM0 = 10 * DEG, EPS0 = 0;
static volatile double g_zero = 0;  // keeps the compiler from computing the inputs' results in advance

// makes the compiler compute every component of the result, although nothing reads it
template <class R> static inline void keep(const R& r) { __asm__ volatile("" : : "r"(&r) : "memory"); }

static inline double now() { timespec t; clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }

template <class F> double fastest(F f, double budget = 0.4) {
  f(); double t0 = now(); f(); double one = now() - t0;
  int per = std::max(1, (int)(2e-3 / std::max(one, 1e-9)));
  double best = 1e99, end = now() + budget;
  do { double a = now(); for (int i = 0; i < per; ++i) f(); best = std::min(best, (now() - a) / per); } while (now() < end);
  return best;
}

struct Row { double value; std::vector<double> grad; std::string note; };

static void emit(const char* task, double seconds, const Row& row) {
  printf("{\"peer\":\"%s\",\"task\":\"%s\",\"seconds\":%.6g,\"value\":%.17g,\"grad\":[", PEER, task, seconds, row.value);
  for (size_t i = 0; i < row.grad.size(); ++i) printf("%s%.17g", i ? "," : "", row.grad[i]);
  printf("],\"note\":\"%s\"}\n", row.note.c_str()); fflush(stdout);
}

struct Bench {
  std::string only; bool once = false; long count = -1;
  Bench(int argc, char** argv) {
    if (argc > 1) only = argv[1];
    if (argc > 2) once = std::string(argv[2]) == "once";
    if (argc > 3) count = atol(argv[3]);
  }
  bool wants(const char* task) const { return only.empty() || only == task; }

  // op(lam, eps) -> result; show(result) -> Row
  template <class Op, class Show> void task(const char* name, Op op, Show show) const {
    if (!wants(name)) return;
    auto work = [&] { auto r = op(LAM0 + g_zero, EPS0 + g_zero); keep(r); };
    if (count >= 0) { for (long i = 0; i < count; ++i) work(); return; }
    auto result = op(LAM0, EPS0);
    emit(name, once ? 0 : fastest(work), show(result));
  }

  // T6: loft 0..25 deg x attack -10..10 deg, 1000 x 1000 points; a row is one loft.
  // row(lam, first, stride, add) computes a row at every stride-th attack angle from `first` on,
  // and calls add(j, carry, dlam, deps) for each. Every 25th row is timed. Instructions are counted
  // in rows 250 and 750, from first = stride/2 on. The value in the output is the check sum over
  // every 25th row and column. "grad" is the check sum without the row of loft 0, where the ball
  // does not spin and carry has a kink.
  template <class RowOp> void grid(int stride, RowOp row) const {
    if (!wants("T6")) return;
    const int N = 1000, every = 25;
    auto lam = [&](int i) { return 25 * DEG * i / (N - 1) + g_zero; };
    if (count >= 0) {
      for (long k = 0; k < count; ++k) for (int i : {250, 750}) row(lam(i), stride / 2, stride, [](int, double c, double l, double e) { double r[3] = {c, l, e}; keep(r); });
      return;
    }
    double total = 0, sum = 0, spinning = 0; long points = 0;
    for (int i = 0; i < N; i += every) {
      double best = 1e9;
      for (int repeat = 0; repeat < (once ? 1 : 5); ++repeat) {
        double start = now(), s = 0;
        row(lam(i), 0, stride, [&](int j, double c, double l, double e) { if (j % every == 0) s += c + 1e-3 * (l + e); });
        best = std::min(best, now() - start);
        if (repeat == 0) sum += s, spinning += i ? s : 0, points += (N + stride - 1) / stride;
      }
      total += best;
    }
    emit("T6", once ? 0 : total / points, {sum, {spinning}, std::to_string(points) + " points"});
  }
  static double attack(int j) { return (-10 + 20.0 * j / 999) * DEG; }
};
