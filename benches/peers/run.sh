#!/bin/sh
# Compares longdrive with its peers and writes the tables to results.md and docs/performance.md.
# Usage: benches/peers/run.sh [--python]
#   --python  the Python peers too (NumPy, SciPy, Numba, JAX, in a virtual environment in target; takes some minutes)
# CORE: processor of all measurements (default: the last one). If clang-14, valgrind or ceres is
# missing, apt-get installs it without a prompt; what apt-get cannot install is left out.
set -eu
cd "$(dirname "$0")"
build=target/peers
mkdir -p "$build"

install() {
  command -v apt-get >/dev/null && [ "$(id -u)" = 0 ] || return 0
  apt-get install -qq --no-install-recommends "$@" >/dev/null 2>&1 || {
    apt-get update -qq && apt-get install -qq --no-install-recommends "$@" >/dev/null
  } || echo "not installed: $*" >&2
}
command -v clang++-14 >/dev/null || command -v clang++ >/dev/null || install clang-14
command -v valgrind >/dev/null || install valgrind
[ -e /usr/include/ceres/jet.h ] || install libceres-dev libeigen3-dev
clang=$(command -v clang++-14 || command -v clang++ || true)

# compile COMPILER NAME SOURCE OPTION...: one binary for this machine, and one for valgrind, which lacks AVX-512
compile() {
  compiler=$1 name=$2 source=cpp/$3
  shift 3
  for machine in native haswell; do
    binary=$build/$name.$machine
    [ -n "$(find cpp run.sh -newer "$binary" 2>/dev/null || echo none)" ] || continue
    "$compiler" -O3 "-march=$machine" -fno-math-errno -fno-trapping-math -std=c++17 "-DPEER=\"${name%.twelve}\"" \
      "$@" "$source" -o "$binary.new" -lmvec -lm 2>"$build/log" && mv "$binary.new" "$binary" ||
      { rm -f "$binary"; [ "$machine" = haswell ] || { echo "$name does not compile:" >&2; cat "$build/log" >&2; }; }
  done
}
wide=""
if grep -q avx512f /proc/cpuinfo; then wide=1; fi
for compiler in g++ $clang; do
  tag=gcc
  case $compiler in *clang*) tag=clang ;; esac
  compile "$compiler" "cpp-dual-$tag" dual.cpp
  compile "$compiler" "cpp-tuned-$tag" tuned.cpp
  compile "$compiler" "cpp-tuned-$tag.twelve" tuned_twelve.cpp -mprefer-vector-width=512
  compile "$compiler" "cpp-simd4-$tag" tuned.cpp -DVEC=v4 -DINLEXP
  # AVX-512, which this machine may lack, and which the binary for valgrind (haswell) cannot have
  if [ -n "$wide" ]; then
    compile "$compiler" "cpp-simd8-$tag" tuned.cpp -DVEC=v8 -DINLEXP -DRSQRT -mprefer-vector-width=512
    compile "$compiler" "cpp-simd2x8-$tag" tuned.cpp -DTWO_VECTORS -DVEC=V2 -DINLEXP -DRSQRT -mprefer-vector-width=512
  fi
done
if [ -e /usr/include/ceres/jet.h ]; then compile g++ ceres-jet ceres.cpp -DNDEBUG -I/usr/include/eigen3; fi
gcc -O2 -march=native cpp/machine.c -o "$build/machine"

# the library with optimization level 3 and thin local LTO, as cargo compiles it for a package that
# depends on it; the program with the release profile of this repository, as it is installed
cargo build --release --locked --target-dir target --config profile.release.lto=false --config profile.release.package.longdrive.opt-level=3
cargo build --release --locked --target-dir target --package longdrive --bin longdrive

python=""
if [ "${1:-}" = --python ]; then
  python=target/venv/bin/python
  [ -x "$python" ] || python3 -m venv target/venv
  "$python" -m pip install --quiet --requirement python/requirements.txt
fi

exec python3 compare.py $python
