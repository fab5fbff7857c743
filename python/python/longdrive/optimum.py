"""The answers of searches."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _longdrive
from ._longdrive import Setup
from .reply import Reply

if TYPE_CHECKING:
    from .request import Request
    from .types import Amount, Floats

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
"""Final statuses of searches. The index in this list is the ``status`` of an optimum; -1 stands
for other statuses."""


class Optimum(Reply):
    """An optimum, with the fields of SciPy's ``OptimizeResult`` and the results of derivatives."""

    x: Floats
    """Values of the varied parameters, SI, shape (n,); without an optimum, the starting point."""
    names: list[str]
    """The varied parameters, in the order of ``x``."""
    fun: float
    """The value of the objective, SI, not negated for a maximum; NaN without an optimum. For
    ``robust``, the value with the setup's own model."""
    jac: Floats | None
    """The gradient at the optimum, shape (n,); NaN without an optimum. None for ``robust``, whose
    design balances several models."""
    success: bool
    """True if the search converged."""
    status: int
    """0 for success, else a code for the end of the search (``ended``)."""
    ended: str
    """The end of the search: ``converged``, ``stalled``, ``infeasible``, …"""
    message: str
    """The end of the search in a sentence."""
    nit: int
    """Number of iterations."""
    nfev: int
    """Number of evaluations."""
    optimum: dict[str, float] | None
    """``x`` by name; None without an optimum."""
    multipliers: dict[str, dict[str, float | None]]
    """Multipliers of the bounds by parameter."""
    prices: dict[str, float]
    """The gain of ``fun`` for each SI unit by which a bound or constraint is relaxed; for a bound
    of ``robust``, the decrease of the largest loss."""
    constraints: list[dict[str, Any]]
    """The constraints with their values and multipliers."""
    maxcv: float | None
    """The largest violation of a constraint, SI of its outcome; 0 without constraints, None without
    an optimum and for ``robust``."""
    kkt_residual: float | None
    """The residual of the optimality conditions."""
    started: Setup
    """The setup of the call, with its argument ``launch``."""
    tolerance: Amount | None
    """The largest error of a length, as in the call; ``hess`` has the same."""
    own_step: bool
    """True if the call keeps the method and step of its setup; ``hess`` keeps them too."""
    reply: Reply
    """The answer of the command: the content of its ``--json``."""

    @property
    def setup(self) -> Setup:
        """The setup at the optimum."""
        started: Setup = self["started"]
        return started._with_values(dict(zip(self["names"], self["x"])))

    @cached_property
    def hess(self) -> Floats | None:
        """The exact Hessian of the objective at the optimum, SI, shape (n, n).

        For ``robust``, the Hessian with the setup's own model; None for an optimum over many
        swings.
        """
        if self["reply"].get("swings") is not None or self["optimum"] is None:
            return None
        # not longdrive.hessian: an attribute does not warn
        _, _, hessian = _longdrive.hessian(
            self.setup,
            self["reply"]["objective"],
            self["names"],
            self["tolerance"],
            self["own_step"],
        )
        return hessian

    def __missing__(self, key: str) -> Any:
        # compute these two only at the first access
        if key in ("hess", "setup"):
            return getattr(self, key)
        raise KeyError(key)

    def __getstate__(self) -> None:
        return None

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (dict(self),))


def optimum(reply: Reply, request: Request) -> Optimum:
    """The answer of a search as an optimum."""
    place: dict[str, float] | None = reply.get("optimum")
    at: dict[str, float] = place or reply.get("start") or {}
    models = reply.get("models")
    value = reply.get("value") if models is None else _with_own_model(reply)
    gradient = reply.get("gradient") or {}
    names = list(at)
    multipliers = reply.get("multipliers") or {}
    of_bounds = {
        f"{name} {side}": value
        for name, sides in multipliers.items()
        for side, value in sides.items()
        if value
    }
    constraints = reply.get("constraints") or []
    of_constraints = {
        row["expression"]: row["multiplier"] for row in constraints if row.get("multiplier")
    }
    has_violations = "constraints" in reply and place
    violations = (row["violation"] for row in constraints)
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
        command=reply["command"],
        nit=reply.get("iterations") or 0,
        nfev=reply.get("evaluations") or 0,
        optimum=place,
        multipliers=multipliers,
        prices={**of_bounds, **of_constraints},
        constraints=constraints,
        maxcv=max(violations, default=0.0) if has_violations else None,
        kkt_residual=reply.get("kkt_residual"),
        warnings=reply["warnings"],
        held=reply.held,
        advice=reply.advice,
        started=request.setup_with_launch(),
        tolerance=request.values.get("tolerance"),
        own_step=request.values.get("own_step", False),
        reply=reply,
    )


def _with_own_model(reply: Reply) -> float | None:
    """The objective of a robust design with the setup's own model, which is the first model.

    It is the best value with this model, made worse by the loss of the robust design.
    """
    own = reply["models"][0]
    if own["value"] is None or own["loss"] is None:
        return None
    loss: float = own["loss"]
    value: float = own["value"]
    return value + loss if reply["sense"] == "minimize" else value - loss
