"""The examples run, and reach the program's optimum."""

from __future__ import annotations

import functools
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"
NEEDS = {
    "dask_sweep": "distributed",
    "jax_newton": "jax",
    "ray_sweep": "ray",
    "scipy_optimum": "scipy",
    "spark_sweep": "pyspark",
    "torch_ascent": "torch",
}


@functools.cache
def run(name: str, *arguments: str) -> str:
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    # set PYSPARK_PYTHON: otherwise workers of Spark use the python3 of the path, which may be
    # another
    # fmt: skip
    done = subprocess.run(
        [sys.executable, EXAMPLES / f"{name}.py", *arguments],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYSPARK_PYTHON": sys.executable},
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("name", sorted(path.stem for path in EXAMPLES.glob("*.py")))
def test_an_example_runs(name: str, tmp_path: Path) -> None:
    # the argument of an example of a sweep is the folder for its files
    assert run(name, *([str(tmp_path / "drives")] if name.endswith("_sweep") else []))


def test_scipy_ends_at_the_programs_optimum() -> None:
    # README: loft 6.12 deg, attack angle on its bound of 5 deg, carry 274.7 m
    found = [float(number) for number in re.findall(r"-?\d+\.\d+", run("scipy_optimum"))]
    assert found == pytest.approx([6.12, 5.00, 274.7], abs=0.05)


def test_jax_and_torch_end_at_one_loft() -> None:
    ascent = run("torch_ascent")
    lofts = [float(number) for number in re.findall(r"\d+\.\d+", run("jax_newton").splitlines()[0])]
    assert lofts == pytest.approx([lofts[0]] * len(lofts), abs=1e-8)
    assert float(re.findall(r"\d+\.\d+", ascent)[0]) == pytest.approx(lofts[0], abs=1e-5)
