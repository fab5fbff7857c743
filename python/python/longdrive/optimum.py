"""What searches answer."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from . import _longdrive
from ._longdrive import Setup
from ._question import Question
from .reply import Reply
from .types import Floats

__all__ = ["Optimum", "optimum"]

STATUSES = [
    "converged",
    "stalled",
    "stalled-at-kink",
    "iteration-limit",
    "infeasible",
    "unbounded",
    "interrupted",
    "undetermined",
    "outweighed",
    "no-flight",
    "diverged",
    "undefined",
    "misfit",
]
"""How a search ends; the place in this list is the ``status`` of an optimum, -1 for any other."""


class Optimum(Reply):
    """An optimum, with the fields of SciPy's ``OptimizeResult`` and what exact derivatives tell beside them.

    | field | what it is |
    |---|---|
    | ``x`` | the values of the varied parameters, SI, shape (n,); ``names`` says which they are; where nothing was found, where the search began |
    | ``fun`` | the value of what was looked for, as asked (not negated where it is maximized), SI; of ``robust`` that with the setup's own model; NaN where nothing was found |
    | ``jac`` | its gradient there, shape (n,); NaN where nothing was found; None for ``robust``, whose design holds several models in balance |
    | ``hess`` | its Hessian there, shape (n, n); of ``robust`` that with the setup's own model; None for an optimum over many swings |
    | ``success`` | whether the search converged |
    | ``status`` | 0 where it did; else how it ended, a number |
    | ``ended`` | the same in a word: ``converged``, ``stalled``, ``infeasible``, … |
    | ``message`` | the same in a sentence |
    | ``nit``, ``nfev`` | iterations and evaluations |
    | ``maxcv`` | the largest violation of a constraint, SI of its outcome; 0 without any, None where nothing was found, and for ``robust`` |

    ``multipliers`` are those of the bounds, by parameter; ``prices`` say what ``fun`` gains for each SI unit that a bound or constraint is
    relaxed, or for a bound of ``robust`` what the greatest loss falls by; ``setup`` is the setup at the optimum; ``reply`` is all that the program's ``--json`` prints.
    """

    @property
    def setup(self) -> Setup:
        """The setup at the optimum."""
        started: Setup = self["started"]
        return started.replace(dict(zip(self["names"], self["x"])))

    @cached_property
    def hess(self) -> Floats | None:
        """The exact Hessian of what was looked for at the optimum, SI."""
        if self["reply"].get("swings") is not None or self["optimum"] is None:
            return None
        return np.asarray(
            _longdrive.hessian(self.setup, self["reply"]["objective"], self["names"])[2]
        )

    def __missing__(self, key: str) -> Any:
        # computed when asked for, as keys too
        if key in ("hess", "setup"):
            return getattr(self, key)
        raise KeyError(key)

    def __getstate__(self) -> None:
        return None

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (dict(self),))


def optimum(reply: Reply, question: Question) -> Optimum:
    """The answer of a search."""
    place: dict[str, float] | None = reply.get("optimum")
    at: dict[str, float] = place or reply.get("start") or {}
    models = reply.get("models")
    value = reply.get("value") if models is None else _with_own_model(reply)
    gradient = reply.get("gradient") or {}
    names = list(at)
    multipliers = reply.get("multipliers") or {}
    of_bounds = {
        f"{name} {side}": value for name, sides in multipliers.items() for side, value in sides.items() if value
    }
    constraints = reply.get("constraints") or []
    of_constraints = {
        row["expression"]: row["multiplier"] for row in constraints if row.get("multiplier")
    }
    ended = reply["status"]
    return Optimum(
        x=np.array([at[name] for name in names]),
        names=names,
        fun=np.nan if value is None else value,
        jac=np.array([gradient.get(name, np.nan) for name in names]) if models is None else None,
        success=ended == "converged",
        status=STATUSES.index(ended) if ended in STATUSES else -1,
        ended=ended,
        message=reply["message"],
        nit=reply.get("iterations"),
        nfev=reply.get("evaluations"),
        optimum=place,
        multipliers=multipliers,
        prices={**of_bounds, **of_constraints},
        constraints=constraints,
        maxcv=max(
            (row["violation"] for row in constraints), default=0.0
        ) if "constraints" in reply and place else None,
        kkt_residual=reply.get("kkt_residual"),
        warnings=reply["warnings"],
        started=question.setup,
        reply=reply,
    )


def _with_own_model(reply: Reply) -> float | None:
    """What was looked for, of a robust design with the model of the setup, which is the first: its best less what is lost beside it."""
    own = reply["models"][0]
    if own["value"] is None or own["loss"] is None:
        return None
    value: float = own["value"] + (own["loss"] if reply["sense"] == "minimize" else -own["loss"])
    return value
