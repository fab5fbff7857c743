"""SciPy's optimizers on the problems that `optimizers --serve` evaluates. Writes a line with each
outcome to standard output.

Each solve has its own process with its own evaluator, and a time limit of 10 s. The time is
SciPy's own: it excludes the functions that SciPy calls (the wait for the evaluator, the
conversions).
"""

import json
import math
import multiprocessing
import subprocess
import sys
import time
import warnings

import numpy as np
from scipy.optimize import Bounds, NonlinearConstraint, minimize

TOLERANCE = 1e-10
# tolerance for solvers that stop when the decrease of f is small: the decrease is of second order
# in the error of x
FALL = 1e-14
ITERATIONS = 1000
PATIENCE = 10.0
REPETITIONS = 3


class Evaluator:
    """A running `optimizers --serve`."""

    def __init__(self, program):
        self.process = subprocess.Popen(
            [program, "--serve"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def ask(self, request):
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def numbers(values, missing=math.nan):
    return np.array([missing if value is None else value for value in values], dtype=float)


def matrix(rows, n):
    return np.array([numbers(row) for row in rows], dtype=float).reshape(-1, n)


class Point:
    """f, c and their derivatives at x."""

    def __init__(self, answer, n):
        self.f = answer["f"]["value"]
        self.f = math.nan if self.f is None else self.f
        self.gradient = numbers(answer["f"]["gradient"])
        self.hessian = matrix(answer["f"]["hessian"], n)
        self.c = numbers([c["value"] for c in answer["c"]])
        self.jacobian = matrix([c["gradient"] for c in answer["c"]], n)
        self.hessians = [matrix(c["hessian"], n) for c in answer["c"]]


class Oracle:
    """A problem that counts its evaluations (points, not calls) and their time."""

    def __init__(self, evaluator, problem):
        self.evaluator = evaluator
        self.name = problem["name"]
        self.start = numbers(problem["start"])
        self.n = len(self.start)
        self.low = numbers(problem["low"], -math.inf)
        self.high = numbers(problem["high"], math.inf)
        self.least = numbers(problem["least"], -math.inf)
        self.most = numbers(problem["most"], math.inf)
        self.known = {}
        self.spent = 0.0

    def reading(self, read):
        """The function x ↦ read(point at x). Its time does not count as SciPy's time."""

        def function(x, *more):
            started = time.perf_counter()
            key = np.asarray(x, dtype=float).tobytes()
            if key not in self.known:
                if np.all(np.isfinite(x)):
                    answer = self.evaluator.ask(
                        {"problem": self.name, "x": [float(value) for value in x]}
                    )
                else:
                    nothing = {
                        "value": None,
                        "gradient": [None] * self.n,
                        "hessian": [[None] * self.n] * self.n,
                    }
                    answer = {"f": nothing, "c": [nothing] * len(self.least)}
                self.known[key] = Point(answer, self.n)
            result = read(self.known[key], *more)
            self.spent += time.perf_counter() - started
            return result

        return function

    def bounds(self):
        if np.all(np.isinf(self.low)) and np.all(np.isinf(self.high)):
            return None
        return Bounds(self.low, self.high)


def slsqp(oracle):
    equal = oracle.least == oracle.most
    above = ~equal & np.isfinite(oracle.most)
    below = ~equal & np.isfinite(oracle.least)
    constraints = []
    if equal.any():
        constraints.append({
            "type": "eq",
            "fun": oracle.reading(lambda at: at.c[equal] - oracle.most[equal]),
            "jac": oracle.reading(lambda at: at.jacobian[equal]),
        })
    if above.any() or below.any():
        constraints.append(
            {
                "type": "ineq",
                "fun": oracle.reading(
                    lambda at: np.concatenate(
                        [oracle.most[above] - at.c[above], at.c[below] - oracle.least[below]]
                    )
                ),
                "jac": oracle.reading(
                    lambda at: np.concatenate([-at.jacobian[above], at.jacobian[below]])
                ),
            }
        )
    return minimize(
        oracle.reading(lambda at: at.f),
        oracle.start.copy(),
        method="SLSQP",
        jac=oracle.reading(lambda at: at.gradient.copy()),
        bounds=oracle.bounds(),
        constraints=constraints,
        options={"ftol": FALL, "maxiter": ITERATIONS},
    )


def trust_constr(oracle):
    """Runs trust-constr with gtol = 0, so that only the tests of trust region and barrier parameter
    end a search.

    The gtol test checks the gradient of the Lagrangian with least-squares multipliers, but neither
    complementarity nor the barrier parameter. With gtol = 1e-10 a search stops far from the optimum
    on many problems with inequalities.
    """
    constraints = []
    if len(oracle.least):
        constraints = NonlinearConstraint(
            oracle.reading(lambda at: at.c.copy()),
            oracle.least,
            oracle.most,
            jac=oracle.reading(lambda at: at.jacobian.copy()),
            hess=oracle.reading(lambda at, v: sum(weight * h for weight, h in zip(v, at.hessians))),
        )
    return minimize(
        oracle.reading(lambda at: at.f),
        oracle.start.copy(),
        method="trust-constr",
        jac=oracle.reading(lambda at: at.gradient.copy()),
        hess=oracle.reading(lambda at: at.hessian.copy()),
        bounds=oracle.bounds(),
        constraints=constraints,
        options={"gtol": 0.0, "xtol": TOLERANCE, "barrier_tol": TOLERANCE, "maxiter": ITERATIONS},
    )


SOLVERS = {"SciPy SLSQP": slsqp, "SciPy trust-constr": trust_constr}


def solve(program, solver, problem, pipe):
    """Sends the outcome of each repetition through `pipe`."""
    warnings.simplefilter("ignore")
    evaluator = Evaluator(program)
    for _ in range(REPETITIONS):
        oracle = Oracle(evaluator, problem)
        started = time.perf_counter()
        result = SOLVERS[solver](oracle)
        seconds = time.perf_counter() - started - oracle.spent
        pipe.send({
            "solver": solver,
            "problem": problem["name"],
            "status": str(result.message),
            "x": [float(x) if math.isfinite(x) else None for x in result.x],
            "evaluations": len(oracle.known),
            "iterations": int(result.nit),
            "seconds": seconds,
        })
    evaluator.close()


def run(context, program, solver, problem):
    """The outcome of the last repetition, with the time of the fastest repetition."""
    receive, send = context.Pipe(duplex=False)
    process = context.Process(target=solve, args=(program, solver, problem, send))
    process.start()
    send.close()
    found, why = None, "failed"
    try:
        while receive.poll(PATIENCE):
            outcome = receive.recv()
            seconds = (
                outcome["seconds"] if found is None else min(outcome["seconds"], found["seconds"])
            )
            found = {**outcome, "seconds": seconds}
        why = "more than 10 s"
    except EOFError:
        pass
    process.kill()
    process.join()
    failed = {"solver": solver, "problem": problem["name"], "status": why, "x": []}
    return found or {**failed, "evaluations": 0, "iterations": None, "seconds": 0.0}


def main():
    program = sys.argv[1]
    evaluator = Evaluator(program)
    problems = evaluator.ask({})
    evaluator.close()
    context = multiprocessing.get_context("fork")
    for solver in SOLVERS:
        print(solver, file=sys.stderr)
        for problem in problems:
            print(json.dumps(run(context, program, solver, problem)), flush=True)


if __name__ == "__main__":
    main()
