"""What the package costs beside the program: one gradient, a million drives, a batch of JAX.

Run on a quiet machine, with both built in release: LONGDRIVE_PROGRAM=target/release/longdrive python benches/measure.py
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
import timeit
from collections.abc import Callable
from pathlib import Path

import numpy as np

import longdrive

NAMES = ["club.loft", "swing.attack_angle"]
ROWS = 1_000_000


def best(work: Callable[[], object], rounds: int = 5) -> float:
    """The least time of some rounds, s."""
    return min(timeit.repeat(work, number=1, repeat=rounds))


def of_a_call() -> None:
    """One gradient, and what is left of its time where the point is known: all that is not the
    drive."""
    calls = 20_000
    carry = longdrive.objective("mae494", "carry", NAMES)
    points = [carry.x0 + 1e-9 * k for k in range(calls)]
    asked = carry.fun_and_jac

    def same() -> None:
        for _ in points:
            asked(points[0])

    def others() -> None:
        for x in points:
            asked(x)

    known, new = best(same) / calls, best(others) / calls
    print(
        f"value and gradient by two: {1e6 * new:.2f} us, of which the binding {1e6 * known:.2f} us"
    )


def of_rows() -> None:
    """A million drives with gradients, beside the program that writes them to a file."""
    draw = np.random.default_rng(1)
    points = {
        "club.loft": np.radians(draw.uniform(5, 15, ROWS)),
        "swing.speed": draw.uniform(36, 58, ROWS),
    }
    took = best(lambda: longdrive.batch("tour-average", points, "carry", "points"), 3)
    print(f"batch: {ROWS / took / 1e6:.3f} million drives with gradients a second")
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
    own = {name: values[:200_000] for name, values in points.items()}
    setup = longdrive.Setup(
        {"preset": "tour-average", "flight.method": "dp8", "flight.step": "0.3 s"}
    )
    took = best(lambda: longdrive.batch(setup, own, "carry", "points", own_step=True), 3)
    print(f"batch with dp8 in steps of 0.3 s: {0.2 / took:.3f} million")
    try:
        import jax

        from longdrive.jax import outcome
    except ImportError:
        return
    jax.config.update("jax_enable_x64", True)
    both = jax.jit(jax.vmap(jax.value_and_grad(outcome(setup, "carry", list(own)))))
    x = jax.block_until_ready(jax.numpy.asarray(np.stack(list(own.values()), axis=1)))
    jax.block_until_ready(both(x))
    took = best(lambda: jax.block_until_ready(both(x)), 3)
    print(f"JAX vmap of value and gradient, the same drives: {0.2 / took:.3f} million")


if __name__ == "__main__":
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", "import longdrive"], check=True)
    print(
        f"import in a new process: {1e3 * (time.perf_counter() - began):.0f} ms, with Python's own start"
    )
    of_a_call()
    of_rows()
