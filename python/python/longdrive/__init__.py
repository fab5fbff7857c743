"""The longest golf drive, with exact derivatives.

A clubhead strikes a ball, the ball flies with drag, lift, spin decay and wind, and lands. Every
outcome has exact gradients and Hessians with respect to every parameter.

>>> import longdrive
>>> drive = longdrive.simulate("tour-average")
>>> drive.status
'landed'
>>> wrt = ["club.loft", "swing.speed"]
>>> value, gradient = longdrive.gradient("tour-average", of="carry", wrt=wrt)
>>> abs(value - drive["carry"]) < 1e-9
True

Numbers are SI and radians; a text has its unit. Bad input raises :class:`InputError`, a valid
request without an answer :class:`NoAnswerError`; both are subclasses of :class:`Error`.
"""

from __future__ import annotations

from . import _supported  # noqa: F401  before any compiled module
from . import commands, dask, jax, parts, plot, ray, spark, torch  # noqa: F401
from ._longdrive import Objective, Setup, __version__, outcomes, parameters, presets
from .batches import batch
from .commands import *  # noqa: F403
from .derivatives import Gradient, Hessian, Jacobian, gradient, hessian, jacobian, objective
from .drive import Drive, Trajectory, simulate
from .errors import (
    Error,
    InputError,
    InternalError,
    Interrupted,
    LongdriveWarning,
    NoAnswerError,
    UnknownKeyError,
)
from .optimum import Optimum
from .picture import Picture
from .reply import Reply
from .sweeps import sweep
from .table import Status, Table

__all__ = [
    "Drive",
    "Error",
    "Gradient",
    "Hessian",
    "InputError",
    "InternalError",
    "Interrupted",
    "Jacobian",
    "LongdriveWarning",
    "NoAnswerError",
    "Objective",
    "Optimum",
    "Picture",
    "Reply",
    "Setup",
    "Status",
    "Table",
    "Trajectory",
    "UnknownKeyError",
    "__version__",
    "batch",
    "gradient",
    "hessian",
    "jacobian",
    "objective",
    "outcomes",
    "parameters",
    "plot",
    "presets",
    "simulate",
    "sweep",
]
__all__ += commands.__all__


def __dir__() -> list[str]:
    return sorted(__all__)
