"""Tables of shots, points and swings: dicts of columns, tables of pandas, polars and pyarrow."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from . import _longdrive
from .arguments import kind_of, outcome_names
from .errors import InputError
from .quantities import contains_quantities, elements_of, is_quantity
from .table import Table

__all__ = [
    "columns_of",
    "csv_of",
    "head_of",
    "names_in_si",
    "points_in_si",
    "warnings_of_results",
]


def columns_of(table: Any) -> Any:
    """The columns of a table by name; other values unchanged.

    For a :class:`longdrive.Table`, its points. For a frame, the columns without statuses, outcomes
    and derivatives, which a frame that was made from such a table has.

    Raises
    ------
    InputError
        For a frame with two columns of one name.
    """
    if isinstance(table, Table):
        return table.points
    frame = None if isinstance(table, Mapping) else _columns_of_frame(table)
    if frame is None or not all(isinstance(name, str) for name, _ in frame):
        return table
    columns: dict[str, Any] = {}
    for name, column in frame:
        if name in columns:
            raise InputError(f"points: two columns have the name '{name}'; keep one")
        if not _is_result(name):
            columns[name] = column.to_numpy()
    return columns


def _is_result(name: str) -> bool:
    """True for the name of a status, an outcome or a derivative in a table of results."""
    is_derivative = name.startswith("d_") and "/d_" in name
    return name == "status" or is_derivative or name in outcome_names()


def warnings_of_results(table: Any) -> list[str]:
    """A warning about the columns of a frame that are results, which a batch does not read.

    A frame whose results have their units was made from a :class:`longdrive.Table`: no warning.
    """
    if isinstance(table, (Table, Mapping)):
        return []
    units = _units_of(table)
    known = {*units, "status"} if units else set()
    names = [name for name, _ in _columns_of_frame(table) or () if isinstance(name, str)]
    results = [name for name in names if _is_result(name) and name not in known]
    if not results:
        return []
    what = "columns not read, since they are results and not parameters"
    return [f"points: {what}: {', '.join(results)}"]


def _columns_of_frame(table: Any) -> list[tuple[Any, Any]] | None:
    """The heads and columns of a table of pandas, polars or pyarrow; None for another value."""
    if hasattr(table, "itercolumns"):  # pyarrow
        return list(zip(table.column_names, table.itercolumns()))
    if hasattr(table, "iter_columns"):  # polars
        return [(column.name, column) for column in table.iter_columns()]
    # pandas: a Series, such as a row of a frame, has no `columns`
    if all(hasattr(table, name) for name in ("items", "to_numpy", "columns")):
        return list(table.items())
    return None


def names_in_si(table: Any, columns: Any) -> set[str]:
    """The parameters of a table that are known to be in SI.

    Such are those of a :class:`longdrive.Table`, and those of a table of pyarrow or pandas that
    was made from one: its metadata or its ``attrs`` have their units.

    Parameters
    ----------
    table : Any
        The table.
    columns : Any
        Its :func:`columns_of`.

    Raises
    ------
    InputError
        For a parameter in another unit, and a lazy frame of polars.
    """
    if isinstance(table, Table):
        return set(table.parameters)
    if type(table).__name__ == "LazyFrame":
        raise InputError("a LazyFrame has no values before its collect(); give frame.collect()")
    units = _units_of(table)
    if not units or not isinstance(columns, dict):
        return set()
    for name in columns:
        expected = _longdrive.unit_of(name)
        if expected is not None and units.get(name, expected) != expected:
            raise InputError(
                f"the column '{name}' has the unit '{units[name]}'; expected '{expected}', as SI: "
                "convert its values, and change the unit in the table"
            )
    return {name for name in columns if name in units}


def points_in_si(table: Any) -> dict[str, Any] | None:
    """The points of a table if all are known to be in SI; None for other tables.

    Raises
    ------
    InputError
        As :func:`names_in_si`.
    """
    columns: Any = columns_of(table)
    names = names_in_si(table, columns)
    return columns if names and len(names) == len(columns) else None


def _units_of(table: Any) -> dict[str, str]:
    """The units that a table of pyarrow or pandas has for its columns."""
    schema: Any = getattr(table, "schema", None)
    if hasattr(schema, "field") and hasattr(table, "column_names"):
        metadata = {name: schema.field(name).metadata or {} for name in table.column_names}
        return {name: of[b"unit"].decode() for name, of in metadata.items() if b"unit" in of}
    units = getattr(table, "attrs", {}).get("units")
    return dict(units) if isinstance(units, Mapping) else {}


def csv_of(name: str, table: Any) -> bytes:
    """A table in memory as the text of a CSV file, which the commands read.

    Parameters
    ----------
    name : str
        The argument, for messages.
    table : Any
        A dict of columns, or a table of pandas, polars or pyarrow.

    Raises
    ------
    InputError
        For a value that is not a table, and columns of different lengths.
    """
    if isinstance(table, Table):
        return csv_of(name, points_with_units(table.points))
    in_si = points_in_si(table)
    if in_si is not None:
        return csv_of(name, points_with_units(in_si))
    columns = table.items() if isinstance(table, Mapping) else _columns_of_frame(table)
    if columns is not None:
        return _csv_of_columns(name, columns)
    raise InputError(
        f"{name} is {kind_of(table)}; expected a file, a dict of columns, or a table of pandas, "
        "polars or pyarrow"
    )


def points_with_units(points: Mapping[str, Any]) -> dict[str, Any]:
    """Points in SI, with the SI unit in the head of each column: ``club.loft [rad]``."""
    return {head_of(name): values for name, values in points.items()}


def head_of(name: str) -> str:
    """The head of a column in SI, with its unit: ``club.loft [rad]``."""
    unit = _longdrive.unit_of(name)
    return f"{name} [{unit}]" if unit else name


def _csv_of_columns(name: str, table: Iterable[tuple[Any, Any]]) -> bytes:
    # imported here: `import longdrive` does not need them
    import csv
    import io

    heads, columns = [], []
    for head, values in table:
        # raise UnicodeEncodeError for a lone surrogate
        str(head).encode()
        heads.append(head)
        columns.append(_column(name, head, values))
    lengths = sorted({len(column) for column in columns})
    if len(lengths) > 1:
        raise InputError(
            f"{name}: its columns have {' and '.join(map(str, lengths))} rows; expected the same "
            "number in each"
        )
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(heads)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns))
    return text.getvalue().encode()


def _column(name: str, head: Any, values: Any) -> list[Any]:
    """The values of a column.

    Raises
    ------
    InputError
        For values that are not a sequence of one dimension, and quantities of pint.
    """
    if is_quantity(values) or contains_quantities(values):
        found = f"is {kind_of(values)}" if is_quantity(values) else "has quantities with units"
        raise InputError(
            f"{name}: the column '{head}' {found}; the head of a column names the unit, so give "
            "the numbers in that unit, as in values.to('mph').magnitude"
        )
    for method in ("to_pylist", "to_list"):  # pyarrow; pandas and polars
        if hasattr(values, method):
            values = getattr(values, method)()
            break
    elements = elements_of(values)
    shape: tuple[int, ...] = getattr(values, "shape", (len(elements or ()),))
    if elements is None or len(shape) != 1:
        found = kind_of(values) if elements is None else f"of shape {shape}"
        raise InputError(
            f"{name}: the column '{head}' is {found}; expected a value for each row, shape (rows,)"
        )
    return list(elements)


def _cell(value: Any) -> Any:
    """A value as a cell of CSV; a missing value is an empty cell."""
    if type(value) is float:
        return value if value == value else ""
    if value is None or value is np.ma.masked:
        return ""
    if type(value).__name__ in ("NAType", "NaTType") or value != value:
        return ""
    is_numpy = hasattr(value, "dtype") and value.dtype.kind in "fiu"
    # NumPy's own repr of a number has the name of its type: float64(…)
    return repr(float(value)) if is_numpy else value
