"""Very many drives at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from . import _longdrive
from ._longdrive import Setup
from .angles import check_unit, columns_in_radians, refuse_degrees_of_points, warnings_of_columns
from .arguments import count_of, switch_of
from .errors import InputError, Interrupted, interruptible, warn_of
from .progress import follower
from .quantities import contains_quantities, elements_of, is_quantity, to_si, tolerance_of
from .setups import CallSetup
from .table import Table
from .tables import columns_of, names_in_si, warnings_of_results

if TYPE_CHECKING:
    from .progress import Progress
    from .types import AngleUnit, Names, PointsLike, SetupLike

__all__ = ["batch"]


def batch(
    setup: SetupLike,
    points: PointsLike,
    of: Names = "carry",
    wrt: Names | None = None,
    *,
    hessians: bool = False,
    tolerance: float | str | None = None,
    own_step: bool = False,
    angles: AngleUnit = "rad",
    threads: int = 0,
    progress: Progress = False,
    first_row: int = 0,
) -> Table:
    """Outcomes, and their exact derivatives, at very many points, on all processors.

    A row without a drive has a status, and no exception is raised. The rows do not depend on the
    number of threads, and equal the rows of ``longdrive sweep``.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    points : PointsLike
        Parameters with arrays of one length, shape (rows,), or with one value for all rows. Numbers
        are SI; a text has its unit; quantities of pint, and lists of them, are converted. Also a
        table of pandas, polars or pyarrow with such columns, or a :class:`Table`, whose points are
        used. Arrays of 64-bit floats, also read-only ones and those with strides, are read 65,536
        rows at a time, without a copy of the whole array.
    of : Names
        Outcomes, a name or several; ``"all"`` for every one.
    wrt : Names | None
        Parameters to differentiate by, a name or several; ``"points"`` for the parameters
        of the points; without it no derivatives.
    hessians : bool
        Compute second derivatives too: by `wrt`, or by the parameters of the points if `wrt` is
        None. All rows use the step that is chosen for them together.
    tolerance : float | str | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.
    angles : AngleUnit
        The unit of angles without a unit. ``"deg"`` is refused for a :class:`Table`, and for a
        table that has the unit of a column, as one that was made from a Table: such points are SI.
    threads : int
        The number of threads; 0 for the number of processors of this process.
    progress : Progress
        True for a bar, or a function of the rows done and all rows.
    first_row : int
        The first row to compute, to continue after an interruption.

    Returns
    -------
    Table
        The outcomes and derivatives.

    Raises
    ------
    InputError
        For an unknown name, or an array of the wrong shape or type.
    Interrupted
        After Ctrl-C, with the rows that were done.

    Warns
    -----
    LongdriveWarning
        Once, with all ``warnings`` of the table.

    Examples
    --------
    >>> import longdrive, numpy as np
    >>> points = {"club.loft": np.radians([8.0, 10.5, 13.0, np.nan]), "swing.speed": "110 mph"}
    >>> table = longdrive.batch("tour-average", points, of="carry", wrt="club.loft")
    >>> table.counts()
    {'landed': 3, 'out-of-range': 1}
    >>> table["carry"].shape, table.gradients.shape
    ((4,), (4, 1, 1))
    """
    if switch_of("hessians", hessians) and wrt is None:
        wrt = "points"
    with interruptible("longdrive.batch was interrupted before the first row"), follower(
        "drives", progress
    ) as show:
        check_unit(angles)
        call = CallSetup.of(setup, angles)
        columns: Any = columns_of(points)
        in_si = names_in_si(points, columns)
        if in_si:
            refuse_degrees_of_points(angles)
        if isinstance(columns, Mapping):
            columns = columns_in_radians(columns, angles)
            call.refuse_idle(name for name in columns if isinstance(name, str))
        table = computed(
            call.setup,
            columns,
            of,
            wrt,
            tolerance=tolerance,
            own_step=own_step,
            threads=threads,
            show=show,
            first_row=first_row,
            hessians=hessians,
        )
    table.warnings[:0] = [*call.warnings_of_drive, *warnings_of_results(points)]
    if isinstance(columns, Mapping) and angles == "rad":
        bare = {name: columns[name] for name in columns if name not in in_si}
        table.warnings += warnings_of_columns(bare)
    warn_of(table.warnings, table)
    return table


def _without_units(points: Any) -> Any:
    """Converts quantities of pint in the points to numbers in SI, because NumPy would drop their
    units."""
    if not isinstance(points, Mapping) or not any(
        is_quantity(values) or contains_quantities(values) for values in points.values()
    ):
        return points

    def converted(name: str, values: Any) -> Any:
        unit = _longdrive.unit_of(name) if isinstance(name, str) else None
        if unit is None:
            # an unknown name: the batch refuses it later
            return values
        try:
            if contains_quantities(values):
                return [to_si(value, unit) for value in elements_of(values) or ()]
            return to_si(values, unit)
        except InputError as error:
            raise InputError(f"points: {name}: {error}") from None

    return {name: converted(name, values) for name, values in points.items()}


def _interrupted(after: int, whole: int) -> str:
    advice = (
        "goes on, and Table.concatenate([table, rest]) joins both"
        if after < whole
        else "has nothing left to do"
    )
    return (
        f"longdrive.batch was interrupted after {after} of {whole} rows, which are in `table` of "
        f"this exception; batch(…, first_row={after}) {advice}"
    )


def computed(
    setup: Setup,
    points: Any,
    of: Names,
    wrt: Names | None,
    *,
    tolerance: float | str | None = None,
    own_step: bool = False,
    threads: int,
    show: Callable[[int, int], object] | None,
    first_row: int = 0,
    hessians: bool = False,
    ranges: list[tuple[str, float, float]] | None = None,
    function: _longdrive.Integration | None = None,
    interrupted: Callable[[int, int], str] = _interrupted,
) -> Table:
    """The table of a batch.

    Parameters
    ----------
    setup : Setup
        The setup.
    points : Any
        Parameters with arrays.
    of : Names
        Outcomes.
    wrt : Names | None
        Parameters to differentiate by.
    tolerance : float | str | None
        The largest error of a length.
    own_step : bool
        Keep method and step of the setup.
    threads : int
        The number of threads.
    show : Callable[[int, int], object] | None
        The function that shows the progress.
    first_row : int
        The first row to compute.
    hessians : bool
        Compute second derivatives.
    ranges : list[tuple[str, float, float]] | None
        The ranges for which the step is chosen; without them, the ranges of the points.
    function : _longdrive.Integration | None
        Method and step of a function, chosen before.
    interrupted : Callable[[int, int], str]
        The message after an interruption, from the rows done and all rows.
    """
    found = _longdrive.batch(
        setup,
        _without_units(points),
        of,
        wrt,
        tolerance_of(tolerance),
        switch_of("own_step", own_step),
        count_of("threads", threads),
        show,
        count_of("first_row", first_row),
        switch_of("hessians", hessians),
        ranges,
        function,
    )
    done, parameters = found.done, found.parameters
    columns = found.columns[:, :done]
    table = Table(
        status=found.status[:done],
        columns=columns[len(parameters) :],
        points=columns[: len(parameters)],
        of=found.of,
        wrt=found.wrt,
        parameters=parameters,
        units=found.units,
        hessians=None if found.hessians is None else found.hessians[:done],
        rows=range(first_row, first_row + done),
        warnings=found.warnings,
        setup=setup,
    )
    raised = found.raised
    if raised is None:
        return table
    if isinstance(raised, KeyboardInterrupt):
        raise Interrupted(interrupted(first_row + len(table), found.rows), table) from raised
    raise raised
