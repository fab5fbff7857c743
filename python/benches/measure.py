"""Measures the cost of the package: import, one drive, one gradient, a million drives, a batch of
JAX.

Run on a quiet machine, with both built in release: LONGDRIVE_PROGRAM=target/release/longdrive python benches/measure.py
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import tempfile
import timeit
from collections.abc import Callable
from pathlib import Path

import numpy as np

import longdrive

NAMES = ["club.loft", "swing.attack_angle"]
ROWS = 1_000_000
FOLDER = Path(__file__).parent


def best(work: Callable[[], object], rounds: int = 5) -> float:
    """The least time of some rounds, s."""
    return min(timeit.repeat(work, number=1, repeat=rounds))


def of_a_call() -> None:
    """Compares the time of value and gradient by two parameters with Rust's `Evaluator` in the same
    profile."""
    # short rounds: other processes disturb only some of them
    calls, rounds = 500, 200
    carry = longdrive.objective("tour-average", "carry", NAMES)
    points = [carry.x0 + 1e-9 * k for k in range(calls)]
    fun_and_jac = carry.fun_and_jac

    def objective() -> None:
        for x in points:
            fun_and_jac(x)

    command = ["cargo", "bench", "--quiet", "--package", "longdrive-python"]
    command += ["--profile", "wheel", "--bench", "evaluator"]

    def evaluator() -> float:
        done = subprocess.run(command, check=True, capture_output=True, text=True, cwd=FOLDER)
        return float(done.stdout)

    # measure by turns, because the speed of a shared machine changes
    by_turns = [(1e6 * best(objective, rounds) / calls, evaluator()) for _ in range(3)]
    here, rust = map(min, zip(*by_turns))
    print(
        f"objective, value and gradient by two: {here:.2f} us, Rust's Evaluator {rust:.2f} us: "
        f"{here / rust:.2f} times"
    )


def of_a_drive() -> None:
    """One drive and its gradient, for a setup whose step is known; setups and their pickles."""
    setup = longdrive.Setup({"club.loft": "10 deg", "swing.speed": "110 mph"})
    state = pickle.dumps(setup)
    work: dict[str, Callable[[], object]] = {
        'gradient(of="carry")': lambda: longdrive.gradient(setup, of="carry", wrt=NAMES),
        'simulate(of="carry")': lambda: longdrive.simulate(setup, of="carry"),
        "simulate()": lambda: longdrive.simulate(setup),
        "simulate().report": lambda: longdrive.simulate(setup).report,
        "gradient of a new setup": lambda: longdrive.gradient(setup.replace({"club.loft": 0.2})),
        'Setup("mae494")': lambda: longdrive.Setup("mae494"),
        "pickle.dumps(setup)": lambda: pickle.dumps(setup),
        "pickle.loads(state)": lambda: pickle.loads(state),
    }
    for name, call in work.items():
        call()
        took = min(timeit.repeat(call, number=200, repeat=7)) / 200
        print(f"{name}: {1e6 * took:.1f} us")


def of_rows() -> None:
    """Measures a million drives with gradients: ``batch``, the program with a file, and JAX."""
    draw = np.random.default_rng(1)
    points = {
        "club.loft": np.radians(draw.uniform(5, 15, ROWS)),
        "swing.speed": draw.uniform(36, 58, ROWS),
    }
    of_batch = best(lambda: longdrive.batch("tour-average", points, "carry", "points"), 3)
    print(f"batch: {ROWS / of_batch / 1e6:.3f} million drives with gradients a second")
    program = os.environ.get("LONGDRIVE_PROGRAM")
    if program:
        with tempfile.TemporaryDirectory() as folder:
            command = [
                program,
                "sweep",
                "--quiet",
                "--sample",
                str(ROWS),
                "--over",
                "club.loft=5deg..15deg",
                "--over",
                "swing.speed=36m/s..58m/s",
            ]
            command += ["--gradient", "--overwrite", "-o", str(Path(folder) / "rows.parquet")]
            took = best(lambda: subprocess.run(command, check=True, capture_output=True), 3)
        print(f"program: {ROWS / took / 1e6:.3f} million, with the writing of a Parquet file")
    try:
        import jax
    except ImportError:
        return
    jax.config.update("jax_enable_x64", True)
    carry = longdrive.jax.outcome("tour-average", "carry", list(points))
    both = jax.jit(jax.vmap(jax.value_and_grad(carry)))
    x = jax.block_until_ready(jax.numpy.asarray(np.stack(list(points.values()), axis=1)))
    jax.block_until_ready(both(x))
    of_jax = best(lambda: jax.block_until_ready(both(x)), 3)
    print(
        f"JAX vmap of value and gradient, the same drives: {ROWS / of_jax / 1e6:.3f} million, "
        f"{1e6 * of_jax / ROWS:.2f} us a row, {of_jax / of_batch:.2f} times the time of batch"
    )


def of_import() -> None:
    """Compares the import in a new process with NumPy's."""

    def importing(name: str) -> float:
        command = [sys.executable, "-c", f"import {name}"]
        return best(lambda: subprocess.run(command, check=True), 1)

    # measure by turns, because the load of the machine changes
    times = [(importing("numpy"), importing("longdrive")) for _ in range(20)]
    alone, whole = (min(each) for each in zip(*times))
    print(f"import: {1e3 * whole:.0f} ms, NumPy alone {1e3 * alone:.0f} ms, with Python's start")


if __name__ == "__main__":
    of_import()
    of_a_drive()
    of_a_call()
    of_rows()
