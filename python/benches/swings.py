"""Compares the optimizers of longdrive and SciPy on the design of a head for many swings, and
prints a table like the one in docs/optimizer.md.

Usage: swings.py [SCENARIOS ...], with the package built in release. All solvers get the same
objective with exact gradients and, if they use them, Hessians. The residual is computed here, from
the design only: the largest component of u - P(u - g/|f|), with u and g in units of the ranges and
P the projection on them.
"""

from __future__ import annotations

import logging
import re
import sys
import time
import warnings
from typing import Any

import numpy as np
from scipy.optimize import minimize

import longdrive

GOAL = "mean(carry) - 0.5*std(lateral)"
VARY = [
    "club.loft=6deg..16deg",
    "club.bulge_radius=200mm..600mm",
    "club.roll_radius=200mm..600mm",
    "club.cg_depth=25mm..45mm",
    "club.inertia.xx=4500g cm^2..5700g cm^2",
    "club.inertia.yy=3000g cm^2..4200g cm^2",
    "club.inertia.zz=2000g cm^2..3000g cm^2",
    "club.mass=190g..210g",
]
SWINGS: dict[str, Any] = {
    "distribution": [
        "swing.speed=normal(107mph,3mph)",
        "swing.attack_angle=truncated(-1deg,2deg,-6deg,6deg)",
        "swing.path=normal(0deg,2deg)",
        "swing.face_angle=normal(0deg,2deg)",
        "strike.high=normal(0mm,6mm)",
        "strike.toe=normal(0mm,8mm)",
    ],
    "correlation": "swing.path,swing.face_angle=0.6",
}
SI = {"deg": np.pi / 180, "mm": 1e-3, "g cm^2": 1e-7, "g": 1e-3}
NAMES = [text.split("=")[0] for text in VARY]
YARD = 0.9144


def ranges() -> tuple[Any, Any]:
    """The lower ends and the widths of the ranges, SI."""
    ends = []
    for text in VARY:
        low, unit, high = re.match(r"[\w.]+=(\d+)(\D.*?)\.\.(\d+)", text).groups()  # type: ignore[union-attr]
        ends.append((float(low) * SI[unit], float(high) * SI[unit]))
    low, high = np.array(ends).T
    return low, high - low


LOW, WIDTH = ranges()


class Scaled:
    """The negated goal as a function of parameters in units of their ranges, with the number and
    the time of its evaluations."""

    def __init__(self, setup: Any, scenarios: int) -> None:
        self.goal = longdrive.objective(
            setup, GOAL, NAMES, "max", invalid="nan", scenarios=scenarios, **SWINGS
        )
        self.points: set[bytes] = set()
        self.spent = 0.0

    def evaluated(self, what: Any, u: Any) -> Any:
        self.points.add(np.asarray(u).tobytes())
        began = time.perf_counter()
        found = what(LOW + np.asarray(u) * WIDTH)
        self.spent += time.perf_counter() - began
        return found

    def fun(self, u: Any) -> float:
        value = float(self.evaluated(self.goal.fun, u))
        # trust-constr also evaluates points outside of the ranges, where the head may be impossible
        return value if np.isfinite(value) else np.inf

    def jac(self, u: Any) -> Any:
        return np.nan_to_num(self.evaluated(self.goal.jac, u) * WIDTH)

    def hess(self, u: Any) -> Any:
        return np.nan_to_num(self.evaluated(self.goal.hess, u) * np.outer(WIDTH, WIDTH))

    def residual(self, x: Any) -> tuple[float, float]:
        u = np.clip((np.asarray(x) - LOW) / WIDTH, 0.0, 1.0)
        return float(
            np.max(np.abs(u - np.clip(u - self.jac(u) / abs(self.fun(u)), 0.0, 1.0)))
        ), -self.fun(u)


class LastIteration(logging.Handler):
    """Keeps the time of the last iteration that the command reported."""

    at = 0.0
    spent = 0.0

    def emit(self, record: logging.LogRecord) -> None:
        if GOAL in record.getMessage() and "KKT" in record.getMessage():
            self.at, self.spent = time.perf_counter(), time.process_time()


def ours(scenarios: int) -> tuple[Any, dict[str, Any]]:
    """Runs the command and times its search, up to the last iteration. The work after the search
    (other swings, the mean swing) is timed separately."""
    shown = LastIteration()
    logging.getLogger("longdrive").addHandler(shown)
    logging.getLogger("longdrive").setLevel(logging.INFO)
    began, cpu = time.perf_counter(), time.process_time()
    best = longdrive.optimize(
        "tour-average", maximize=GOAL, vary=VARY, scenarios=scenarios, **SWINGS
    )
    ended, spent = time.perf_counter(), time.process_time()
    logging.getLogger("longdrive").removeHandler(shown)
    row = {
        "x": best.x,
        "status": best.ended,
        "iterations": best.nit,
        "evaluations": best.nfev,
        "wall": shown.at - began,
        "cpu": shown.spent - cpu,
    }
    print(
        f"<!-- {scenarios}: the whole command {ended - began:.2f} s, {spent - cpu:.2f} s of processor time -->",
        flush=True,
    )
    return best, row


def theirs(scaled: Scaled, method: str, start: Any) -> dict[str, Any]:
    """Runs SciPy from the same start, with tolerances of 1e-10 (SLSQP: 1e-14 for the goal)."""
    options: dict[str, Any] = (
        {"ftol": 1e-14, "maxiter": 1000}
        if method == "SLSQP"
        else {"xtol": 1e-10, "gtol": 1e-10, "barrier_tol": 1e-10, "maxiter": 1000}
    )
    hess = {} if method == "SLSQP" else {"hess": scaled.hess}
    began, cpu = time.perf_counter(), time.process_time()
    found = minimize(
        scaled.fun,
        start,
        jac=scaled.jac,
        bounds=[(0.0, 1.0)] * len(NAMES),
        method=method,
        options=options,
        **hess,
    )
    took, spent = time.perf_counter() - began, time.process_time() - cpu
    x = LOW + np.clip(found.x, 0.0, 1.0) * WIDTH
    output = re.sub(r"[\s.]+$", "", str(found.message)).replace("|", "/")
    return {
        "x": x,
        "status": output,
        "iterations": found.nit,
        "evaluations": len(scaled.points),
        "wall": took,
        "cpu": spent,
    }


def main() -> None:
    warnings.simplefilter("ignore")
    print(
        "| Swings | Solver | Status | Iterations | Evaluations | Time, s | Processor time, s | KKT residual | Goal, yd |"
    )
    print("|--:|---|---|--:|--:|--:|--:|--:|--:|")
    for scenarios in [int(text) for text in sys.argv[1:]] or [500, 10_000]:
        best, row = ours(scenarios)
        # the method and step that the search chose for an error of 1 um
        chosen = {name: best.reply["setup"][name] for name in ["flight.method", "flight.step"]}
        setup = longdrive.Setup({"preset": "tour-average", **chosen})
        judge = Scaled(setup, scenarios)
        start = np.clip((judge.goal.x0 - LOW) / WIDTH, 0.0, 1.0)
        for name, found in [
            ("longdrive", row),
            *(
                (f"SciPy {method}", theirs(Scaled(setup, scenarios), method, start))
                for method in ["SLSQP", "trust-constr"]
            ),
        ]:
            residual, value = judge.residual(found["x"])
            print(
                f"| {scenarios} | {name} | {found['status']} | {found['iterations']} | {found['evaluations']} | {found['wall']:.2f} | {found['cpu']:.2f} " f"| {residual:.0e} | {value / YARD:.9f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
