"""The path of the ball as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _longdrive
from .types import Floats

__all__ = ["Trajectory"]


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The flight of a ball, SI, in the ground frame: x up, y right of the target, z to the target.

    ``polars.DataFrame(path)``, ``pyarrow.table(path)`` and ``pandas.DataFrame.from_arrow(path)``
    make a table of it.
    """

    time: Floats
    """Time from the launch, s, shape (points,)."""
    position: Floats
    """Position, m, shape (points, 3)."""
    velocity: Floats
    """Velocity, m/s, shape (points, 3)."""
    spin: Floats
    """Angular velocity, rad/s, shape (points, 3)."""

    def __post_init__(self) -> None:
        for array in (self.time, self.position, self.velocity, self.spin):
            array.flags.writeable = False

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
