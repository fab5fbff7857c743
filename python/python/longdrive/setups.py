"""The setup of a call, with the values that a dict states and the warnings about its angles."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from ._longdrive import Setup
from .angles import warnings_of

if TYPE_CHECKING:
    from .types import AngleUnit, SetupLike

__all__ = ["CallSetup"]


class CallSetup(NamedTuple):
    """The setup of a call."""

    setup: Setup
    stated: list[str]
    """The parameters that a dict in place of a setup states, except launch conditions. A dict must
    state all conditions of a launch, also those that a column replaces."""
    warnings: list[str]
    """Warnings about angles without a unit."""

    @classmethod
    def of(
        cls, given: SetupLike, angles: AngleUnit = "rad", base: Setup | None = None
    ) -> CallSetup:
        """The setup for an argument. Its warnings belong to the answer of the call.

        A dict that names no preset starts from ``base``, by default from the preset
        ``tour-average``.
        """
        setup, stated, bare_angles = Setup._of_call(given, angles, base)
        return cls(setup, stated, warnings_of(bare_angles))

    @property
    def warnings_of_drive(self) -> list[str]:
        """The warnings for a drive of this setup: also about values of the club that a given launch
        replaces."""
        return [*self.setup._warnings_of_club(), *self.warnings]

    def refuse_idle(
        self,
        columns: Iterable[str] = (),
        why: str = "every drive has a value of its own",
    ) -> None:
        """Refuses stated values without effect, as the commands do.

        Parameters
        ----------
        columns : Iterable[str]
            Parameters with values of their own in each drive.
        why : str
            The reason, for the message.

        Raises
        ------
        InputError
            For a parameter that is also a column, that a column replaces (the air density beside
            its temperature), or that no drive uses (the club beside a launch).
        """
        self.setup._refuse_idle(self.stated, list(columns), why)
