"""Tables of shots, points and swings: dicts of columns, tables of pandas, polars and pyarrow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _longdrive
from .arguments import kind_of
from .errors import InputError
from .quantities import contains_quantities, elements_of, is_quantity
from .table import Table

__all__ = ["columns_of", "csv_of", "head_of", "points_in_si"]


def columns_of(table: Any) -> Any:
    """The columns of a table by name; other values unchanged.

    For a :class:`longdrive.Table`, its points. For a frame that was made from such a table, the
    columns without statuses, outcomes and derivatives.
    """
    if isinstance(table, Table):
        return table.points
    if isinstance(table, Mapping):
        return table
    names = getattr(table, "column_names", getattr(table, "columns", None))
    if names is None or not all(isinstance(name, str) for name in names):
        return table
    results = {"status", *(row["name"] for row in _longdrive.outcomes())}
    return {
        name: table[name].to_numpy()
        for name in names
        if name not in results and not name.startswith("d_")
    }


def points_in_si(table: Any) -> dict[str, Any] | None:
    """The points of a table whose columns are known to be in SI; None for other tables.

    Such tables are a :class:`longdrive.Table`, and a table of pyarrow or pandas that was made from
    one: its metadata or its ``attrs`` have the units.
    """
    if isinstance(table, Table):
        return table.points
    units = _units_of(table)
    if not units:
        return None
    columns: dict[str, Any] = columns_of(table)
    are_in_si = all(name in units and units[name] == _longdrive.unit_of(name) for name in columns)
    return columns if columns and are_in_si else None


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
    if hasattr(table, "to_csv"):
        return str(table.to_csv(index=False)).encode()
    if hasattr(table, "write_csv"):
        return str(table.write_csv()).encode()
    if hasattr(table, "to_pydict"):
        return csv_of(name, table.to_pydict())
    if isinstance(table, Mapping):
        return _csv_of_columns(name, table)
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


def _csv_of_columns(name: str, table: Mapping[Any, Any]) -> bytes:
    # imported here: `import longdrive` does not need them
    import csv
    import io

    for head in table:
        # raise UnicodeEncodeError for a lone surrogate
        str(head).encode()
    columns = [_column(name, head, values) for head, values in table.items()]
    lengths = sorted({len(column) for column in columns})
    if len(lengths) > 1:
        raise InputError(
            f"{name}: its columns have {' and '.join(map(str, lengths))} rows; expected the same "
            "number in each"
        )
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(table.keys())
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
    if value is None or value is np.ma.masked:
        return ""
    if type(value).__name__ in ("NAType", "NaTType") or value != value:
        return ""
    is_numpy = hasattr(value, "dtype") and value.dtype.kind in "fiu"
    # NumPy's own repr of a number has the name of its type: float64(…)
    return repr(float(value)) if is_numpy else value
