#!/bin/sh
# Compares longdrive's optimizer with its peers and prints the table. Usage: benches/optimizers/run.sh [DIR]
# DIR (results in this directory by default) gets solvers.md, problems.md, and every outcome as JSON lines.
set -eu
cd "$(dirname "$0")"
out="${1:-results}"
mkdir -p "$out"

[ -x .venv/bin/python ] || python3 -m venv .venv
.venv/bin/pip install --quiet --requirement requirements.txt
# the defaults of Cargo for all crates, thin local LTO and full optimization, instead of this repository's profile
cargo build --release --locked -j1 --target-dir target --config profile.release.lto=false --config profile.release.package.libm.opt-level=3

# one thread, pinned to one processor if possible
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 RAYON_NUM_THREADS=1
pin=""
if command -v taskset >/dev/null; then pin="taskset -c 0"; fi

$pin .venv/bin/python scipy_peer.py target/release/optimizers >"$out/scipy.jsonl"
$pin target/release/optimizers --scipy "$out/scipy.jsonl" -o "$out"
