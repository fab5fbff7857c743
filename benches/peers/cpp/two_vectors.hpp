// Two independent vectors of 8 lanes. An RK4 step is a chain of dependent operations: while one
// vector waits for a result, the processor computes the other vector.
#pragma once
#include "tuned.hpp"
struct V2 { v8 a, b; };
#define O(o) static inline V2 operator o(V2 x, V2 y) { return {x.a o y.a, x.b o y.b}; } static inline V2 operator o(double k, V2 y) { return {k o y.a, k o y.b}; } static inline V2 operator o(V2 x, double k) { return {x.a o k, x.b o k}; }
O(+) O(-) O(*) O(/)
#undef O
static inline V2 operator-(V2 x) { return {-x.a, -x.b}; }
template <> struct L<V2> { typedef L<v8> Y; static constexpr int n = 16;
  static V2 set(double a) { return {Y::set(a), Y::set(a)}; } static V2 sqrt(V2 x) { return {Y::sqrt(x.a), Y::sqrt(x.b)}; } static V2 exp(V2 x) { return {Y::exp(x.a), Y::exp(x.b)}; }
  static V2 sin(V2 x) { return {Y::sin(x.a), Y::sin(x.b)}; } static V2 cos(V2 x) { return {Y::cos(x.a), Y::cos(x.b)}; }
  static void vr(V2 s, V2& v, V2& r) { Y::vr(s.a, v.a, r.a); Y::vr(s.b, v.b, r.b); }
  typedef int M; static M le0(V2 x) { return Y::le0(x.a) | Y::le0(x.b) << 8; } static bool any(M m) { return m; } static bool all(M m) { return m == 65535; }
  static V2 sel(M m, V2 x, V2 y) { return {Y::sel(m & 255, x.a, y.a), Y::sel(m >> 8, x.b, y.b)}; } };
