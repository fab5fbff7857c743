"""One drive."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from html import escape
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from . import _longdrive
from .arguments import no_attribute, switch_of
from .errors import UnknownKeyError, warn_of
from .options import nearest_outcome
from .quantities import tolerance_of
from .trajectory import Trajectory
from .types import Amount, Names, SetupLike

__all__ = ["Drive", "simulate"]


class Drive(Mapping[str, "float | None"]):
    """The outcomes of one drive by name, SI; None for an outcome that it does not have."""

    outcomes: Mapping[str, float | None]
    """The requested outcomes, read-only."""
    trajectory: Trajectory | None
    """The path of the ball, if ``simulate`` was called with ``trajectory=True``."""

    _report: dict[str, Any] | Callable[[], dict[str, Any]]

    def __init__(
        self,
        outcomes: Mapping[str, float | None],
        report: dict[str, Any] | Callable[[], dict[str, Any]],
        trajectory: Trajectory | None = None,
    ) -> None:
        set_once = super().__setattr__
        set_once("outcomes", MappingProxyType(dict(outcomes)))
        set_once("_report", report)
        set_once("trajectory", trajectory)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Drive cannot be changed: {name} = {value!r}")

    @property
    def report(self) -> dict[str, Any]:
        """The answer of ``longdrive simulate --json``, made when it is first asked for."""
        report = self._report
        if callable(report):
            report = report()
            super().__setattr__("_report", report)
        return report

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (dict(self.outcomes), self.report, self.trajectory))

    def __repr__(self) -> str:
        return f"Drive(outcomes={dict(self.outcomes)})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Drive):
            return NotImplemented
        return self.outcomes == other.outcomes and self.report == other.report

    @property
    def status(self) -> str:
        """The end of the drive: ``landed``, ``no-flight`` or ``aloft``."""
        return str(self.report["status"])

    @property
    def message(self) -> str | None:
        """The reason for no landing; None for a drive that lands."""
        message: str | None = self.report["message"]
        return message

    @property
    def warnings(self) -> list[str]:
        """Warnings about the drive."""
        warnings: list[str] = self.report["warnings"]
        return warnings

    def __getitem__(self, name: str) -> float | None:
        """An outcome.

        Raises
        ------
        UnknownKeyError
            For an outcome that was not requested; it is a KeyError.
        """
        try:
            return self.outcomes[name]
        except KeyError:
            pass
        if any(row["name"] == name for row in _longdrive.outcomes()):
            raise UnknownKeyError(
                f"'{name}' was not asked for; simulate(…, of=[…]) gives "
                f"{', '.join(self.outcomes)} here; add it to of"
            )
        raise UnknownKeyError(
            _longdrive.unknown_key(
                "outcome",
                str(name),
                list(self.outcomes),
                "a drive has the outcomes that it was asked for",
            )
        )

    if not TYPE_CHECKING:  # type checkers refuse unknown attributes, too

        def __getattr__(self, name: str) -> Any:
            raise no_attribute(
                self, name, f"outcomes go by name, as in drive['{nearest_outcome(name)}']"
            )

    def __iter__(self) -> Iterator[str]:
        return iter(self.outcomes)

    def __len__(self) -> int:
        return len(self.outcomes)

    def __hash__(self) -> int:
        return hash(tuple(self.outcomes.items()))

    def _repr_html_(self) -> str:
        si = {row["name"]: row["si"] for row in _longdrive.outcomes()}

        def row(name: str, value: float | None) -> str:
            shown = "" if value is None else f"{value:.6g} {si.get(name, '')}"
            return f"<tr><td>{escape(name.replace('_', ' '))}</td><td>{escape(shown)}</td></tr>"

        rows = "".join(row(name, value) for name, value in self.outcomes.items())
        caption = escape(self.message or self.status)
        return f"<table><caption>drive: {caption}</caption><tbody>{rows}</tbody></table>"


def simulate(
    setup: SetupLike = None,
    of: Names | None = None,
    *,
    trajectory: bool = False,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Drive:
    """Computes one drive: impact, flight, landing, bounces and roll.

    A drive without a flight has a status, and None for the outcomes of its flight.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset ``tour-average``.
    of : Names | None
        Outcomes, a name or several; without it all.
    trajectory : bool
        Compute the path of the ball too: points at least every 0.05 s.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    Drive
        The drive.

    Raises
    ------
    InputError
        For an unknown name, or a value outside its range.

    Warns
    -----
    LongdriveWarning
        Once, with all ``warnings`` of the drive.

    Examples
    --------
    >>> import longdrive
    >>> swing = {"preset": "tour-average", "swing.speed": "110 mph"}
    >>> drive = longdrive.simulate(swing, of=["carry", "apex_height"], trajectory=True)
    >>> list(drive)
    ['carry', 'apex_height']
    >>> bool(abs(drive.trajectory.position[:, 0].max() - drive["apex_height"]) < 0.1)
    True
    >>> longdrive.simulate({"swing.attack_angle": "-40 deg"}).status
    'no-flight'
    """
    found = _longdrive.simulate(
        setup,
        of,
        switch_of("trajectory", trajectory),
        tolerance_of(tolerance),
        switch_of("own_step", own_step),
    )
    path = found.path
    drive = Drive(found.outcomes, found.report, None if path is None else Trajectory(*path))
    warn_of(found.warnings, drive)
    return drive
