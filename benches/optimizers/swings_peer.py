"""longdrive's optimizer beside SciPy's on the design of a head for swings that vary: a Markdown table on standard output.

Usage: swings_peer.py PROGRAM [SCENARIOS ...]. Every solver gets the same values, gradients and Hessians from `optimizers --serve-swings`,
in units of the ranges. The residual is the same for all: the largest component of u - P(u - g/|f|), with P the projection on the unit box.
"""

import json
import math
import subprocess
import sys
import time
import warnings

import numpy as np
from scipy_peer import Evaluator, Oracle, slsqp, trust_constr


class Within(Evaluator):
    """Without a value outside the ranges, where trust-constr looks too and no head exists."""

    def ask(self, request):
        x = request.get("x", [])
        if all(0.0 <= value <= 1.0 for value in x):
            return super().ask(request)
        n = len(x)
        return {"f": {"value": math.inf, "gradient": [0.0] * n, "hessian": [[0.0] * n] * n}, "c": []}


def residual(oracle, x):
    x = np.clip(x, 0.0, 1.0)
    at = oracle.reading(lambda at: at)(x)
    return float(np.max(np.abs(x - np.clip(x - at.gradient / abs(at.f), 0.0, 1.0)))), at.f


def row(solver, scenarios, outcome, oracle):
    largest, value = residual(oracle, outcome["x"])
    print(
        f"| {scenarios} | {solver} | {outcome['iterations']} | {outcome['evaluations']} | {outcome['seconds']:.2f} "
        f"| {1e3 * outcome['own']:.1f} | {largest:.0e} | {-value / 0.9144:.9f} |",
        flush=True,
    )


def main():
    warnings.simplefilter("ignore")
    program, counts = sys.argv[1], sys.argv[2:] or ["500", "10000"]
    print("| Scenarios | Solver | Iterations | Evaluations | Time, s | Own time, ms | KKT residual | mean(carry) - 0.5*std(lateral), yd |")
    print("|--:|---|--:|--:|--:|--:|--:|--:|")
    for count in counts:
        evaluator = Within(program, "--serve-swings", count)
        problem = evaluator.ask({})[0]
        ours = json.loads(subprocess.run([program, "--swings", count], capture_output=True, check=True).stdout)
        row("longdrive", count, ours, Oracle(evaluator, problem))
        for name, solve in {"SciPy SLSQP": slsqp, "SciPy trust-constr": trust_constr}.items():
            oracle = Oracle(evaluator, problem)
            started = time.perf_counter()
            result = solve(oracle)
            seconds = time.perf_counter() - started
            found = {
                "x": [float(value) for value in result.x],
                "iterations": result.nit,
                "evaluations": len(oracle.known),
                "seconds": seconds,
                "own": seconds - oracle.spent,
            }
            row(name, count, found, oracle)
        evaluator.close()


if __name__ == "__main__":
    main()
