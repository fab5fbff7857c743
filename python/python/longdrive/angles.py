"""Angles without a unit: radians, or degrees for ``angles="deg"``; a warning for likely degrees."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _longdrive
from .arguments import shown
from .errors import InputError, warn_of
from .quantities import contains_quantities, elements_of, is_quantity

if TYPE_CHECKING:
    from .types import AngleUnit

__all__ = [
    "BareAngles",
    "check_unit",
    "columns_in_radians",
    "refuse_degrees_of_points",
    "suspicious",
    "warn_of_angles",
    "warnings_of",
    "warnings_of_columns",
]

_LARGEST = 0.5
"""Limit, rad: a larger angle without a unit was probably meant in degrees."""


def check_unit(angles: Any) -> AngleUnit:
    """Checks the argument `angles`: the unit of angles that are given as numbers.

    Raises
    ------
    InputError
        For a value other than ``"rad"`` and ``"deg"``.
    """
    if angles not in ("rad", "deg"):
        raise InputError(f"angles = {shown(angles)}; expected 'rad' or 'deg'")
    unit: AngleUnit = angles
    return unit


def suspicious(values: Any) -> float | None:
    """The largest of some angles in radians if it was probably meant in degrees; else None.

    An angle above 0.5 rad is suspicious, unless it has at most four decimals in degrees: such an
    angle, for example ``math.radians(40)``, was converted from degrees.
    """
    array = np.asarray(values, dtype=float)
    if not array.size:
        return None
    # both reductions ignore NaN, and do not copy the array
    ends = np.fmin.reduce(array, axis=None), np.fmax.reduce(array, axis=None)
    largest = float(max(ends, key=abs))
    if not math.isfinite(largest):
        return None
    degrees = math.degrees(largest)
    is_converted = abs(degrees - round(degrees, 4)) < 1e-9 * abs(degrees)
    return largest if abs(largest) > _LARGEST and not is_converted else None


def warnings_of(angles: Iterable[tuple[str, Any]]) -> list[str]:
    """A warning for each parameter whose angles in radians were probably meant in degrees."""
    texts: dict[str, str] = {}
    for name, values in angles:
        angle = suspicious(values)
        if angle is not None and name not in texts:
            texts[name] = (
                f"{name} = {angle:g} is {angle:g} rad: 1 rad is 57.3°; write '{angle:g} deg', or "
                "angles='deg', if degrees are meant"
            )
    return list(texts.values())


class BareAngles:
    """Reads the angles of one call that have no unit, and collects warnings about these angles."""

    def __init__(self, angles: AngleUnit) -> None:
        self.unit = check_unit(angles)
        self._read: list[tuple[str, float]] = []

    def read(self, name: str, number: float) -> float:
        """Converts an angle to radians. Keeps an angle given in radians for the warnings."""
        if self.unit == "deg":
            return math.radians(number)
        self._read.append((name, number))
        return number

    @property
    def numbers(self) -> list[float]:
        """The angles read so far in radians; none if the unit is deg."""
        return [number for _, number in self._read]

    def warnings(self) -> list[str]:
        """The warnings about the angles read so far."""
        return warnings_of(self._read)


def columns_in_radians(points: Mapping[str, Any], angles: AngleUnit) -> dict[str, Any]:
    """Converts numeric angles of the points from the unit `angles` to radians.

    Texts, quantities of pint, and values that a batch refuses stay unchanged.
    """
    if angles == "rad":
        return dict(points)
    return {
        name: _in_radians(values) if _longdrive.unit_of(name) == "rad" else values
        for name, values in points.items()
    }


def _in_radians(degrees: Any) -> Any:
    if contains_quantities(degrees):
        return [_in_radians(element) for element in elements_of(degrees) or ()]
    # convert to 64 bits first: np.radians has 16 bits for numbers of 8 bits
    return np.radians(np.asarray(degrees, dtype=float)) if _is_numeric(degrees) else degrees


def refuse_degrees_of_points(angles: Any) -> None:
    """Refuses degrees for points whose columns have known units; they would have no effect.

    Raises
    ------
    InputError
        For ``angles="deg"``.
    """
    if check_unit(angles) == "deg":
        raise InputError(
            "angles = 'deg': each column of points has the unit in its head, as in "
            "'club.loft [deg]', or else SI, with angles in radians; leave angles out: degrees need "
            "such a head, or numpy.radians(…), and an angle of the setup its unit, as in '9 deg'"
        )


def warnings_of_columns(points: Mapping[str, Any]) -> list[str]:
    """Warnings about the angles of a batch, in radians, that are in range.

    The batch itself warns about angles out of range.
    """
    bare = {
        name: _without_quantities(values)
        for name, values in points.items()
        if isinstance(name, str) and _longdrive.unit_of(name) == "rad"
    }
    return warnings_of(
        (name, values)
        for name, values in bare.items()
        if _is_numeric(values)
        and not _longdrive.is_out_of_range(name, suspicious(values) or 0.0)
    )


def _without_quantities(values: Any) -> Any:
    if not contains_quantities(values):
        return values
    return [element for element in elements_of(values) or () if not is_quantity(element)]


def _is_numeric(values: Any) -> bool:
    """True for the whole numbers and floats that a batch takes: one, or an array or a list."""
    if isinstance(values, str) or is_quantity(values) or contains_quantities(values):
        return False
    if isinstance(values, (list, tuple)) and any(isinstance(x, (bool, np.bool_)) for x in values):
        return False
    try:
        array = np.asanyarray(values)
    except ValueError:  # a list of lists of different lengths
        return False
    is_masked = hasattr(array, "mask")
    return not is_masked and array.dtype.kind in "fiu" and np.can_cast(array.dtype, float)


def warn_of_angles(angles: Iterable[tuple[str, float]], answer: object) -> None:
    """Warns of angles of a setup, in radians, that were probably meant in degrees."""
    warn_of(warnings_of(angles), answer)
