"""One drive."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from html import escape
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from . import _longdrive
from .arguments import no_attribute
from .described import name_or_carry
from .errors import UnknownKeyError, warn_of
from .types import Names, SetupLike

__all__ = ["Drive", "simulate"]


@dataclass(frozen=True)
class Drive(Mapping[str, "float | None"]):
    """The outcomes of one drive, by name, in SI; None where the drive has none."""

    outcomes: Mapping[str, float | None]
    """The outcomes that were asked for; it cannot be changed."""
    report: dict[str, Any] = field(repr=False)
    """All that ``longdrive simulate --json`` says of the drive."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "outcomes", MappingProxyType(dict(self.outcomes)))

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (dict(self.outcomes), self.report))

    def __repr__(self) -> str:
        return f"Drive(outcomes={dict(self.outcomes)})"

    @property
    def status(self) -> str:
        """How it ended: ``landed``, ``no-flight`` or ``aloft``."""
        return str(self.report["status"])

    @property
    def message(self) -> str | None:
        """Why there is no landing; None where there is one."""
        message: str | None = self.report["message"]
        return message

    @property
    def warnings(self) -> list[str]:
        """What a user should know about the drive."""
        warnings: list[str] = self.report["warnings"]
        return warnings

    def __getitem__(self, name: str) -> float | None:
        """An outcome.

        Raises:
            UnknownKeyError: for one that was not asked for; it is a KeyError.
        """
        try:
            return self.outcomes[name]
        except KeyError:
            pass
        if any(row["name"] == name for row in _longdrive.outcomes()):
            raise UnknownKeyError(
                f"'{name}' was not asked for; simulate(…, of=[…]) gives {', '.join(self.outcomes)} here; add it to of"
            )
        raise UnknownKeyError(
            _longdrive.unknown_key(
                "outcome",
                str(name),
                list(self.outcomes),
                "a drive has the outcomes that it was asked for",
            )
        )

    if not TYPE_CHECKING:  # what is no attribute is none to type checkers, too

        def __getattr__(self, name: str) -> Any:
            raise no_attribute(
                self, name, f"outcomes go by name, as in drive['{name_or_carry(name)}']"
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
        return f"<table><caption>drive: {escape(self.message or self.status)}</caption><tbody>{rows}</tbody></table>"


def simulate(setup: SetupLike = None, of: Names | None = None) -> Drive:
    """One drive: impact, flight, landing, and the run on the ground.

    A drive that does not fly is an answer: its status says so, and outcomes of its flight are None.

    >>> import longdrive
    >>> drive = longdrive.simulate({"preset": "tour-average", "swing.speed": "110 mph"}, of=["carry", "apex_height"])
    >>> list(drive)
    ['carry', 'apex_height']
    >>> longdrive.simulate({"swing.attack_angle": "-40 deg"}).status
    'no-flight'

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset ``tour-average``.
        of: outcomes, a name or several; all of them without it.

    Raises:
        InputError: for a name that nothing bears, or a value outside its range.

    Warns:
        LongdriveWarning: once, with all of ``warnings`` of the drive.
    """
    drive = Drive(*_longdrive.simulate(setup, of))
    warn_of(drive.warnings, drive, stacklevel=2)
    return drive
