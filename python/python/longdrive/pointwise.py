"""Outcomes with their derivatives at points of any shape, for bindings to other libraries."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _longdrive
from .arguments import switch_of
from .batches import computed
from .errors import InputError, LongdriveWarning, warn_of
from .quantities import tolerance_of
from .setups import CallSetup

if TYPE_CHECKING:
    from .types import Amount, Floats, Names, SetupLike

__all__ = ["NO_THIRD", "OutcomeFunction", "Pointwise"]

NO_THIRD = (
    "longdrive.{}.outcome has exact first and second derivatives, and a third derivative was asked "
    "for; take it by differences of the Hessian: (hessian(x + h) - hessian(x - h)) / (2 h), with h "
    "of 1e-5 and 64-bit floats"
)
"""The message for a third derivative."""


class Pointwise:
    """Outcomes of a setup as a smooth function of parameters, NaN without a drive.

    Method and step are chosen once, for values around the values of the setup: a step chosen for
    each batch would make the function depend on the batch.
    """

    def __init__(
        self,
        setup: SetupLike,
        of: Names,
        wrt: Names | None,
        tolerance: Amount | None,
        own_step: bool,
    ) -> None:
        call = CallSetup.of(setup)
        call.refuse_idle()
        self.setup = call.setup
        self.warnings = call.warnings_of_drive
        self.is_single = isinstance(of, str) and of != "all"
        names = _longdrive.requested_names(self.setup, of, wrt)
        self.of: list[str] = names[0]
        self.wrt: list[str] = names[1]
        self.step = (tolerance_of(tolerance), switch_of("own_step", own_step))
        self._integration = _longdrive.Integration(self.setup, self.of, self.wrt, *self.step)

    def __reduce__(self) -> tuple[Any, ...]:
        of = self.of[0] if self.is_single else self.of
        return (Pointwise, (self.setup, of, self.wrt, *self.step))

    def check(self, shape: tuple[int, ...], kind: str) -> None:
        """Checks the shape and the kind of numbers of one point.

        Raises
        ------
        InputError
            For another shape or kind.
        """
        if shape != (len(self.wrt),):
            raise InputError(
                f"x has shape {shape}; expected shape ({len(self.wrt)},): {', '.join(self.wrt)}, SI"
            )
        if kind != "f":
            raise InputError(f"x is of kind '{kind}'; expected floats, in SI")

    def __call__(self, x: Any, order: int) -> list[Floats]:
        """Values and derivatives.

        Parameters
        ----------
        x : Any
            Points, shape (…, parameters).
        order : int
            The highest derivative: 0, 1 or 2.

        Returns
        -------
        list[Floats]
            Arrays of the shapes (…, outcomes), (…, outcomes, parameters) and (…, outcomes,
            parameters, parameters).
        """
        lead = x.shape[:-1]
        rows = np.asarray(x, dtype=np.float64).reshape(-1, len(self.wrt))
        points = {name: rows[:, k] for k, name in enumerate(self.wrt)}
        # drop the warnings of the drives: an optimizer calls this very often; simulate and
        # Setup.warnings give them
        by = self.wrt if order else None
        table = computed(
            self.setup,
            points,
            self.of,
            by,
            function=self._integration,
            threads=0,
            show=None,
            hessians=order > 1,
        )
        found = [table.values, table.gradients if order else None, table.hessians]
        return [array.reshape(lead + array.shape[1:]) for array in found if array is not None]


class OutcomeFunction:
    """Outcomes of a setup as a function of another library.

    Pickling stores the arguments of ``outcome``, because a local function cannot be pickled.
    """

    def __init__(
        self,
        outcome: Callable[..., Callable[[Any], Any]],
        point: Pointwise,
        call: Callable[[Any], Any],
    ) -> None:
        self._outcome = outcome
        self._point = point
        self._call = call
        self.__name__ = "outcome"
        self.__doc__ = f"{', '.join(point.of)} of x = ({', '.join(point.wrt)}), SI."
        warn_of(point.warnings, self)

    def __call__(self, x: Any) -> Any:
        return self._call(x)

    def __repr__(self) -> str:
        of, wrt = ", ".join(self._point.of), ", ".join(self._point.wrt)
        return f"<{self._outcome.__module__}.outcome {of} of {wrt}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_outcome_of, (self._outcome, self._point.__reduce__()[1]))


def _outcome_of(
    outcome: Callable[..., Callable[[Any], Any]], arguments: tuple[Any, ...]
) -> Callable[[Any], Any]:
    *given, tolerance, own_step = arguments
    with warnings.catch_warnings():
        # the call that made the function has issued these warnings
        warnings.simplefilter("ignore", LongdriveWarning)
        return outcome(*given, tolerance=tolerance, own_step=own_step)
