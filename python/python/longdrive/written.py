"""Values of Python as the program reads them: numbers with their unit, ranges, tables."""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import count_of, kind_of, shown
from .errors import InputError

if TYPE_CHECKING:
    from pathlib import Path

__all__ = [
    "count_text",
    "elements_of",
    "in_si",
    "is_quantity",
    "number_text",
    "parts_of",
    "point_in_si",
    "write_table",
]


def parts_of(value: Any) -> tuple[Any, ...] | None:
    """The parts of a sequence, whatever its type: a tuple, a list, an array; None of what is no sequence."""
    if isinstance(value, (str, bytes, Mapping, Set)):
        return None
    try:
        return tuple(value)
    except TypeError:
        return None


def count_text(name: str, value: Any) -> str:
    """How many values a range has; an array has it as a float."""
    if isinstance(value, str):
        return value
    return str(
        count_of(
            f"the count of {name}",
            int(value) if isinstance(value, float) and value.is_integer() else value,
            1,
        )
    )


def is_quantity(value: Any) -> bool:
    """Whether something is a quantity of pint. It is known by what it has: pint itself need not be there."""
    return all(hasattr(value, name) for name in ("to", "magnitude", "units"))


def elements_of(values: Any) -> tuple[Any, ...] | None:
    """The elements of a sequence with quantities of pint among them, whose units NumPy would drop; None of anything else."""
    if not hasattr(values, "__len__") or getattr(values, "dtype", object) != object:
        return None
    parts = parts_of(values)
    # one of each type tells: a list may be long
    of_types = {type(part): part for part in parts or ()}
    return parts if any(map(is_quantity, of_types.values())) else None


def in_si(value: Any, unit: str, is_difference: bool = False) -> Any:
    """The number, or the numbers, of a quantity of pint in an SI unit; anything else as it is. Of a difference 2 degC are 2 K.

    Raises:
        InputError: for a quantity of another kind.
    """
    if not is_quantity(value):
        return value
    try:
        if is_difference:
            # pint counts a temperature from its own zero, and a difference of two from none
            value = value - type(value)(0, value.units)
        number = value.to(unit or "dimensionless").magnitude
        # to pint a radian is the number 1
        is_angle = (
            not unit
            and hasattr(value, "to_root_units")
            and "radian" in str(value.to_root_units().units)
        )
    except Exception as error:  # those of pint have no name here
        raise InputError(str(error)) from None
    if is_angle:
        raise InputError(f"{value} is an angle; expected a number without a unit")
    return number


def point_in_si(x: Any, units: Mapping[str, str]) -> Any:
    """A point with a value for each of some parameters, of which `units` has the SI units: quantities of pint as numbers, anything else as it is.

    Raises:
        InputError: for a quantity of another kind; it names the parameter.
    """
    elements = (parts_of(x) or (x,)) if is_quantity(x) else elements_of(x)
    if elements is None:
        return x
    if len(elements) != len(units):
        # the error names its shape
        return [0.0] * len(elements)
    point = []
    for element, (name, unit) in zip(elements, units.items()):
        try:
            point.append(in_si(element, unit))
        except InputError as error:
            raise InputError(f"x: {name}: {error}") from None
    return point


def number_text(value: Any, unit: str, is_difference: bool = False) -> str:
    """A number with its SI unit, to the last digit; a quantity of pint is converted."""
    value = in_si(value, unit, is_difference)
    try:
        # a truth is a number to Python, and no quantity
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        return f"{float(value)!r} {unit}".strip()
    except OverflowError:
        raise InputError(
            f"{shown(value)} is too large for a 64-bit float, which ends at 1.8e308"
        ) from None
    except (TypeError, ValueError):
        message = f"{shown(value)} is {kind_of(value)}; expected a number (SI), or a text with its unit like '10.5 deg'"
        raise InputError(message) from None


def write_table(name: str, table: Any, path: Path) -> None:
    """A table of pandas, polars or pyarrow, or a dict of columns, as CSV."""
    if hasattr(table, "to_csv"):
        table.to_csv(path, index=False)
    elif hasattr(table, "write_csv"):
        table.write_csv(path)
    elif hasattr(table, "to_pydict"):
        write_table(name, table.to_pydict(), path)
    elif isinstance(table, Mapping):
        columns = [_column(name, head, values) for head, values in table.items()]
        lengths = sorted({len(column) for column in columns})
        if len(lengths) > 1:
            raise InputError(
                f"{name}: its columns have {' and '.join(map(str, lengths))} rows; expected as many in each"
            )
        with path.open("w", newline="", encoding="utf-8") as file:
            import csv  # as below: `import longdrive` does not wait for what only some calls need

            write = csv.writer(file)
            write.writerow(table.keys())
            write.writerows([_cell(value) for value in row] for row in zip(*columns))
    else:
        raise InputError(
            f"{name} is {kind_of(table)}; expected a file, a dict of columns, or a table of pandas, polars or pyarrow"
        )


def _column(name: str, head: Any, values: Any) -> list[Any]:
    """The cells of a column.

    Raises:
        InputError: for what has not a value for each row.
    """
    if is_quantity(values) or elements_of(values) is not None:
        found = f"is {kind_of(values)}" if is_quantity(values) else "has quantities with units"
        raise InputError(
            f"{name}: the column '{head}' {found}; the head of a column names the unit, so give the numbers in that unit, as in values.to('mph').magnitude"
        )
    parts = parts_of(values)
    shape: tuple[int, ...] = getattr(values, "shape", (len(parts or ()),))
    if parts is None or len(shape) != 1:
        found = kind_of(values) if parts is None else f"of shape {shape}"
        raise InputError(
            f"{name}: the column '{head}' is {found}; expected a value for each row, shape (rows,)"
        )
    return list(parts)


def _cell(value: Any) -> Any:
    # a masked element of NumPy, pandas.NA and NaT are no values either
    if value is None or value is np.ma.masked or type(value).__name__ in (
        "NAType", "NaTType"
    ) or value != value:
        return ""
    # numbers of NumPy print as Python's own
    return repr(float(value)) if hasattr(value, "dtype") and value.dtype.kind in "fiu" else value
