"""One drive: its outcomes and the path of the ball."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _longdrive
from .arguments import nearest_outcome, no_attribute, outcome_names, switch_of
from .errors import UnknownKeyError, warn_of
from .quantities import tolerance_of
from .setups import CallSetup

if TYPE_CHECKING:
    from .types import Amount, Floats, Names, SetupLike

__all__ = ["Drive", "Trajectory", "simulate"]


class Trajectory:
    """The flight of a ball, SI, in the ground frame: x up, y right of the target, z to the target.

    ``polars.DataFrame(path)``, ``pyarrow.table(path)`` and ``pandas.DataFrame.from_arrow(path)``
    make a table of it.
    """

    def __init__(self, time: Floats, position: Floats, velocity: Floats, spin: Floats) -> None:
        for array in (time, position, velocity, spin):
            array.flags.writeable = False
        self.time = time
        """Time from the launch, s, shape (points,)."""
        self.position = position
        """Position, m, shape (points, 3)."""
        self.velocity = velocity
        """Velocity, m/s, shape (points, 3)."""
        self.spin = spin
        """Angular velocity, rad/s, shape (points, 3)."""

    def __len__(self) -> int:
        return len(self.time)

    def to_dict(self) -> dict[str, Floats]:
        """The columns by name: ``time``, ``position.x``, …, ``spin.z``."""
        columns = {"time": self.time}
        for name, array in self._vectors():
            columns |= {f"{name}.{axis}": array[:, k] for k, axis in enumerate("xyz")}
        return columns

    def _vectors(self) -> list[tuple[str, Floats]]:
        return [("position", self.position), ("velocity", self.velocity), ("spin", self.spin)]

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        units = {"time": "s", "position": "m", "velocity": "m/s", "spin": "rad/s"}
        columns = [
            (name, np.ascontiguousarray(column), units[name.partition(".")[0]])
            for name, column in self.to_dict().items()
        ]
        metadata = {"longdrive": _longdrive.__version__}
        return _longdrive.arrow_stream(columns, None, [], 0, metadata)

    def __repr__(self) -> str:
        return f"<longdrive.Trajectory of {len(self)} points, {self.time[-1]:.3g} s>"


class Drive(Mapping[str, "float | None"]):
    """The outcomes of one drive by name, SI; None for an outcome that the drive does not have."""

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
        """The answer of ``longdrive simulate --json``, computed when it is first read."""
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
        """The reason why the ball does not land; None for a drive that lands."""
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
            For an outcome that was not requested. The exception is also a KeyError.
        """
        try:
            return self.outcomes[name]
        except KeyError:
            pass
        if name in outcome_names():
            raise UnknownKeyError(
                f"'{name}' was not requested; this drive has "
                f"{', '.join(self.outcomes)}; add '{name}' to of, as in simulate(…, of=[…])"
            )
        raise UnknownKeyError(
            _longdrive.unknown_key(
                "outcome",
                str(name),
                list(self.outcomes),
                "a drive has only the outcomes that were requested",
            )
        )

    if not TYPE_CHECKING:  # type checkers refuse unknown attributes, too

        def __getattr__(self, name: str) -> Any:
            raise no_attribute(
                self, name, f"read an outcome by its name, as in drive['{nearest_outcome(name)}']"
            )

    def __iter__(self) -> Iterator[str]:
        return iter(self.outcomes)

    def __len__(self) -> int:
        return len(self.outcomes)

    def __hash__(self) -> int:
        return hash(tuple(self.outcomes.items()))

    def _repr_html_(self) -> str:
        from .notebook import html_of_drive

        return html_of_drive(self)


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
    call = CallSetup.of(setup)
    call.refuse_idle()
    found = _longdrive.simulate(
        call.setup,
        of,
        switch_of("trajectory", trajectory),
        tolerance_of(tolerance),
        switch_of("own_step", own_step),
        call.warnings_of_drive,
    )
    path = found.path
    drive = Drive(found.outcomes, found.report, None if path is None else Trajectory(*path))
    warn_of(found.warnings, drive)
    return drive
