"""One drive."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from html import escape
from typing import Any

from . import _longdrive
from .types import Names, SetupLike

__all__ = ["Drive", "simulate"]


@dataclass(frozen=True)
class Drive(Mapping[str, "float | None"]):
    """The outcomes of one drive, by name, in SI; None where the drive has none."""

    outcomes: dict[str, float | None]
    """The outcomes that were asked for."""
    report: dict[str, Any] = field(repr=False)
    """All that ``longdrive simulate --json`` says of the drive."""

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
        return self.outcomes[name]

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
    """
    return Drive(*_longdrive.simulate(setup, of))
