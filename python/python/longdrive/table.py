"""Tables of very many drives: a status for each row, columns of outcomes and derivatives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from enum import IntEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, Union, overload

import numpy as np

from . import _longdrive
from .arguments import kind_of, nearest_outcome, no_attribute
from .errors import InputError, UnknownKeyError
from .quantities import elements_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._longdrive import Setup
    from .types import Floats

__all__ = ["Status", "Table"]

class Status(IntEnum):
    """The end of the drive of a row. If a number of the row is NaN, the status is the reason."""

    LANDED = 0
    """The ball landed; the row has every requested outcome and derivative."""
    NO_FLIGHT = 1
    """The ball left the face and did not fly. The row has outcomes of the launch only."""
    ALOFT = 2
    """The ball was in the air at ``flight.time_limit``. The row has outcomes of the launch only."""
    DIVERGED = 3
    """The numbers of the flight overflowed: ``flight.step`` is too coarse."""
    NO_STRIKE = 4
    """The club does not strike the ball."""
    OUT_OF_RANGE = 5
    """A value is NaN or outside the range of its parameter, or the inertia tensor is impossible."""
    UNDEFINED = 6
    """The ball landed, but a requested number does not exist: the direction of a vertical launch, the
    total of a ball that never stops."""

    @property
    def label(self) -> str:
        """The status as in files of the program: ``no-flight``."""
        return self.name.lower().replace("_", "-")


class Table:
    """Drives of a batch, in columns of SI numbers. All arrays are read-only.

    ``table["carry"]`` and ``table.derivative("carry", "club.loft")`` are columns, ``table[10:20]``
    is a table of some rows. ``polars.DataFrame(table)``, ``pyarrow.table(table)`` and
    ``pandas.DataFrame.from_arrow(table)`` share the memory, by Arrow's C stream interface; NaN is
    null there. Functions that take points also take a table.

    Examples
    --------
    >>> import longdrive, numpy as np
    >>> loft = np.radians([8.0, 10.5, 13.0])
    >>> table = longdrive.batch("tour-average", {"club.loft": loft}, of=["carry", "spin"])
    >>> table.keys()
    ['club.loft', 'status', 'carry', 'spin']
    >>> again = longdrive.batch("tour-average", table, of=["carry", "spin"])
    >>> again == table
    True
    """

    # make NumPy use the operators of the table: `array == table` is then False, not an array
    __array_ufunc__ = None

    def __init__(
        self,
        *,
        status: npt.NDArray[np.int8],
        columns: Floats,
        points: Floats,
        of: Sequence[str],
        wrt: Sequence[str],
        parameters: Sequence[str],
        units: Sequence[str],
        hessians: Floats | None = None,
        rows: range | None,
        warnings: Sequence[str] = (),
        setup: Setup | None = None,
    ) -> None:
        for array in (status, columns, points, hessians):
            if array is not None:
                array.flags.writeable = False
        self.status = status
        """The end of each drive: codes of :class:`Status`, shape (rows,), int8."""
        self._columns = columns
        self._points = points
        self.of = tuple(of)
        """The outcomes."""
        self.wrt = tuple(wrt)
        """The parameters by which the outcomes are differentiated."""
        self.parameters = tuple(parameters)
        """The parameters with a value in each row."""
        self._units = tuple(units)
        self.hessians = hessians
        """Second derivatives, shape (rows, outcomes, parameters, parameters), if requested."""
        self._rows = rows
        self.warnings = list(warnings)
        """Warnings about all drives of the request, also in a table of some of its rows."""
        self.setup = setup
        """The setup of all drives, without the values of the points."""

    @property
    def first_row(self) -> int | None:
        """The index of this table's first row among all points of the request, from 0.

        None for joined tables that do not follow each other in one request.
        """
        return None if self._rows is None else self._rows.start

    @property
    def values(self) -> Floats:
        """The outcomes, shape (rows, outcomes): a view."""
        values: Floats = self._columns[: len(self.of)].T
        return values

    @property
    def gradients(self) -> Floats:
        """The derivatives, shape (rows, outcomes, parameters): a view."""
        rows = self._columns[len(self.of) :]
        gradients: Floats = rows.reshape(len(self.of), len(self.wrt), len(self)).transpose(2, 0, 1)
        return gradients

    @property
    def points(self) -> dict[str, Floats]:
        """The points by parameter, shape (rows,) each."""
        return dict(zip(self.parameters, self._points))

    @cached_property
    def _names(self) -> dict[str, int]:
        derivatives = [f"d_{of}/d_{by}" for of in self.of for by in self.wrt]
        return {name: k for k, name in enumerate([*self.of, *derivatives])}

    def keys(self) -> list[str]:
        """Names of the columns: parameters, ``status``, outcomes, derivatives.

        A derivative is named ``d_carry/d_club.loft``.
        """
        return [*self.parameters, "status", *self._names]

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each column of numbers; empty for a number without a unit."""
        return dict(zip([*self.parameters, *self._names], self._units))

    def derivative(self, of: str, by: str) -> Floats:
        """The derivative of an outcome by a parameter, SI, shape (rows,).

        Raises
        ------
        UnknownKeyError
            For a derivative that was not requested.
        """
        if of not in self.of:
            raise UnknownKeyError(
                _longdrive.unknown_key(
                    "outcome",
                    of,
                    list(self.of),
                    f"the table has {', '.join(self.of)}; ask for others with of",
                )
            )
        if by not in self.wrt:
            has = f"those by {', '.join(self.wrt)}" if self.wrt else "none"
            known = [row["parameter"] for row in _longdrive.parameters(self.setup)["parameters"]]
            if by not in known:
                raise UnknownKeyError(
                    _longdrive.unknown_key(
                        "parameter", by, [*self.wrt, *known], f"of derivatives the table has {has}"
                    )
                )
            raise UnknownKeyError(
                f"the table has no derivatives by '{by}'; it has {has}; ask for others with wrt, "
                f"as in wrt='{by}'"
            )
        return self._column(f"d_{of}/d_{by}")

    def _column(self, name: str) -> Floats:
        column: Floats
        if name in self._names:
            column = self._columns[self._names[name]]
        elif name in self.parameters:
            column = self._points[self.parameters.index(name)]
        else:
            raise UnknownKeyError(
                _longdrive.unknown_key(
                    "column", name, self.keys(), f"the columns are {', '.join(self.keys())}"
                )
            )
        return column

    if not TYPE_CHECKING:  # type checkers refuse unknown attributes, too

        def __getattr__(self, name: str) -> Any:
            raise no_attribute(
                self,
                name,
                f"read a column by its name, as in table['{nearest_outcome(name)}']; "
                "pandas.DataFrame.from_arrow(table) and polars.DataFrame(table) read all columns",
            )

    @overload
    def __getitem__(  # type: ignore[overload-overlap]
        self, key: Literal["status"]
    ) -> npt.NDArray[np.int8]: ...

    @overload
    def __getitem__(self, key: str) -> Floats: ...

    @overload
    def __getitem__(self, key: slice) -> Table: ...

    def __getitem__(self, key: str | slice) -> Union[Floats, npt.NDArray[np.int8], Table]:
        """A column by its name, or some rows as a table: views, not copies."""
        if isinstance(key, str):
            return self.status if key == "status" else self._column(key)
        if not isinstance(key, slice):
            kind = kind_of(key) if hasattr(key, "__len__") else repr(key)
            raise InputError(
                f"a table has columns by name and rows by slice; {kind} is neither: index its "
                f"columns, as in table['{self.of[0]}'][…]"
            )
        return Table(
            status=self.status[key],
            columns=self._columns[:, key],
            points=self._points[:, key],
            of=self.of,
            wrt=self.wrt,
            parameters=self.parameters,
            units=self._units,
            hessians=None if self.hessians is None else self.hessians[key],
            rows=None if self._rows is None else self._rows[key],
            warnings=self.warnings,
            setup=self.setup,
        )

    def __len__(self) -> int:
        return len(self.status)

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, name: object) -> bool:
        return name in self.keys()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Table):
            return NotImplemented
        names = (self.of, self.wrt, self.parameters) == (other.of, other.wrt, other.parameters)
        same = np.array_equal
        hessians = (
            self.hessians is other.hessians
            or (
                self.hessians is not None
                and other.hessians is not None
                and same(self.hessians, other.hessians, equal_nan=True)
            )
        )
        return (
            names
            and hessians
            and same(self.status, other.status)
            and same(self._columns, other._columns, equal_nan=True)
            and same(self._points, other._points, equal_nan=True)
        )

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> dict[str, Any]:
        """The columns by name, in the order of :meth:`keys`."""
        return {name: self[name] for name in self.keys()}

    def to_pandas(self) -> Any:
        """The columns as a ``pandas.DataFrame``; NaN is a missing value.

        Its ``attrs["units"]`` has the SI units, so that functions accept the frame as points.
        """
        import pandas

        frame = pandas.DataFrame.from_arrow(self)
        frame.attrs["units"] = self.units
        return frame

    def to_polars(self) -> Any:
        """The columns as a ``polars.DataFrame``; NaN is null."""
        import polars

        return polars.DataFrame(self)

    def counts(self) -> dict[str, int]:
        """Numbers of drives by status: ``{"landed": 98, "no-flight": 2}``."""
        counts = np.bincount(self.status, minlength=len(Status))
        return {status.label: int(counts[status]) for status in Status if counts[status]}

    @staticmethod
    def concatenate(tables: Iterable[Table]) -> Table:
        """One table with the rows of several tables, such as before and after an interruption.

        Raises
        ------
        InputError
            For tables of different outcomes, derivatives, parameters or setups.
        """
        parts = elements_of(tables)
        if parts is None:
            raise InputError(
                f"tables is {kind_of(tables)}; expected several tables, as in "
                "Table.concatenate([table, rest])"
            )
        tables = parts
        if not tables:
            raise InputError("nothing to concatenate: give at least one table")
        for number, table in enumerate(tables, start=1):
            if not isinstance(table, Table):
                raise InputError(
                    f"table {number} is {kind_of(table)}; expected a Table, as batch and sweep give it"
                )
        first = tables[0]
        for number, table in enumerate(tables[1:], start=2):
            _refuse_difference(first, table, number)
        seconds = [table.hessians for table in tables if table.hessians is not None]
        return Table(
            status=np.concatenate([table.status for table in tables]),
            columns=np.concatenate([table._columns for table in tables], axis=1),
            points=np.concatenate([table._points for table in tables], axis=1),
            of=first.of,
            wrt=first.wrt,
            parameters=first.parameters,
            units=first._units,
            hessians=np.concatenate(seconds) if seconds else None,
            rows=_joined_rows([table._rows for table in tables]),
            warnings=list(dict.fromkeys(text for table in tables for text in table.warnings)),
            setup=first.setup,
        )

    def __reduce__(self) -> tuple[Any, ...]:
        fields = {
            "status": self.status,
            "columns": self._columns,
            "points": self._points,
            "of": self.of,
            "wrt": self.wrt,
            "parameters": self.parameters,
            "units": self._units,
            "hessians": self.hessians,
            "rows": self._rows,
            "warnings": self.warnings,
            "setup": self.setup,
        }
        return (_unpickled, (fields,))

    def __array__(self, *_: object, **__: object) -> Any:
        # without an error here, NumPy would make an array of the names of the columns
        raise InputError(
            "a table is not a single array: use a column, table.values or table.gradients; a "
            "DataFrame of it is pandas.DataFrame(dict(table)), or "
            "pandas.DataFrame.from_arrow(table)"
        )

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        whole = [
            (
                name, np.ascontiguousarray(self._column(name)), unit
            ) for name, unit in self.units.items()
        ]
        names = [status.label for status in Status]
        status = np.ascontiguousarray(self.status)
        metadata = {"longdrive": _longdrive.__version__}
        return _longdrive.arrow_stream(whole, status, names, len(self.parameters), metadata)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {label}" for label, count in self.counts().items())
        columns = ", ".join(self._names)
        return f"<longdrive.Table of {len(self)} drives ({counts or 'empty'}): {columns}>"

    def _repr_html_(self) -> str:
        from .notebook import html_of_table

        return html_of_table(self)


def _refuse_difference(first: Table, other: Table, number: int) -> None:
    """Refuses a table whose outcomes, derivatives, parameters or setup differ from the first
    table's."""
    compared = {
        "outcomes": (first.of, other.of),
        "derivatives by": (first.wrt, other.wrt),
        "parameters of the points": (first.parameters, other.parameters),
        "second derivatives": ((first.hessians is not None,), (other.hessians is not None,)),
    }
    for what, (one, two) in compared.items():
        if one != two:
            both = " and ".join(", ".join(map(str, names)) or "none" for names in (one, two))
            raise InputError(
                f"tables 1 and {number} differ in {what}: {both}; these must be equal"
            )
    if first.setup == other.setup:
        return
    here, there = ({} if table.setup is None else table.setup.to_dict() for table in (first, other))
    names = [name for name in dict.fromkeys([*here, *there]) if here.get(name) != there.get(name)]
    shown = ", ".join(f"{name} = {here.get(name)} and {there.get(name)}" for name in names[:4])
    more = f", and {len(names) - 4} more" if len(names) > 4 else ""
    raise InputError(
        f"tables 1 and {number} are of different setups: {shown}{more}; a table is of one setup: "
        "give what differs as a parameter of the points, or keep the tables apart"
    )


def _joined_rows(parts: Sequence[range | None]) -> range | None:
    """The rows of joined tables; None unless each table begins where the one before ends."""
    first = parts[0]
    if first is None:
        return None
    end = first.start
    for rows in parts:
        if rows is None or rows.start != end or rows.step != 1:
            return None
        end = rows.stop
    return range(first.start, end)


def _unpickled(fields: dict[str, Any]) -> Table:
    return Table(**fields)
