"""Numbers with units: quantities of pint, and numbers in SI units."""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import Any

import numpy as np

from .arguments import kind_of, shown
from .errors import InputError

__all__ = [
    "contains_quantities",
    "elements_of",
    "is_quantity",
    "number_of",
    "point_in_si",
    "to_si",
    "tolerance_of",
]


def elements_of(value: Any) -> tuple[Any, ...] | None:
    """The elements of a tuple, a list or an array; None for a text, a dict, a set or one value."""
    if isinstance(value, (str, bytes, Mapping, Set)):
        return None
    try:
        return tuple(value)
    except TypeError:
        return None


def is_quantity(value: Any) -> bool:
    """True for a quantity of pint. The check uses its attributes: pint need not be installed."""
    return all(hasattr(value, name) for name in ("to", "magnitude", "units"))


def contains_quantities(values: Any) -> bool:
    """True for a sequence that contains quantities of pint. NumPy would drop their units."""
    if not hasattr(values, "__len__") or getattr(values, "dtype", object) != object:
        return False
    # one element of each type is enough: a list may be long
    of_types = {type(element): element for element in elements_of(values) or ()}
    return any(map(is_quantity, of_types.values()))


def to_si(value: Any, unit: str, is_difference: bool = False) -> Any:
    """The magnitude of a quantity of pint in an SI unit; other values unchanged.

    A difference of 2 degC is 2 K.

    Raises
    ------
    InputError
        For a quantity of another dimension.
    """
    if not is_quantity(value):
        return value
    try:
        if is_difference:
            # subtract 0: for pint the result is a difference of temperatures, to be converted
            # without the offset of the scale
            value = value - type(value)(0, value.units)
        number = value.to(unit or "dimensionless").magnitude
        # a radian is dimensionless in pint
        is_angle = (
            not unit
            and hasattr(value, "to_root_units")
            and "radian" in str(value.to_root_units().units)
        )
    except Exception as error:  # the exception classes of pint cannot be imported here
        raise InputError(str(error)) from None
    if is_angle:
        raise InputError(f"{value} is an angle; expected a number without a unit")
    return number


def tolerance_of(tolerance: Any) -> Any:
    """The argument `tolerance`: a number in m, a text, or None.

    Raises
    ------
    InputError
        For a bool, and a quantity of another dimension.
    """
    if tolerance is None:
        return None
    if isinstance(tolerance, (bool, np.bool_)):
        raise InputError(
            f'tolerance = {tolerance!r}; expected a length, in m or as a text like "1 um"'
        )
    return to_si(tolerance, "m")


def point_in_si(x: Any, units: Mapping[str, str]) -> Any:
    """A point of an optimizer, with its quantities of pint as numbers.

    Parameters
    ----------
    x : Any
        A value for each parameter.
    units : Mapping[str, str]
        The SI units of the parameters.

    Raises
    ------
    InputError
        For a quantity of another dimension. The message names the parameter.
    """
    if is_quantity(x):
        elements = elements_of(x) or (x,)
    elif contains_quantities(x):
        elements = elements_of(x) or ()
    else:
        return x
    if len(elements) != len(units):
        # a wrong length is reported later, by the check of the shape
        return [0.0] * len(elements)
    point = []
    for element, (name, unit) in zip(elements, units.items()):
        try:
            point.append(to_si(element, unit))
        except InputError as error:
            raise InputError(f"x: {name}: {error}") from None
    return point


def number_of(value: Any, unit: str, is_difference: bool = False) -> float:
    """A number in an SI unit, or a quantity of pint converted to it.

    Raises
    ------
    InputError
        For a value that is not a number, and a quantity of another dimension.
    """
    value = to_si(value, unit, is_difference)
    try:
        # Python treats True as the number 1
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        return float(value)
    except OverflowError:
        raise InputError(
            f"{shown(value)} is too large for a 64-bit float, which ends at 1.8e308"
        ) from None
    except (TypeError, ValueError):
        raise InputError(
            f"{shown(value)} is {kind_of(value)}; expected a number (SI), or a text with its unit "
            "like '10.5 deg'"
        ) from None
