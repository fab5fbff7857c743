"""Very many drives at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _longdrive
from ._longdrive import Setup
from .arguments import count_of, switch_of
from .errors import InputError, Interrupted, interruptible, warn_of
from .progress import Progress, follower
from .table import Table
from .types import Names, SetupLike
from .written import elements_of, in_si, is_quantity

__all__ = ["batch"]


def batch(
    setup: SetupLike,
    points: Mapping[str, npt.ArrayLike | str],
    of: Names = "carry",
    wrt: Names | None = None,
    *,
    hessians: bool = False,
    tolerance: float | str | None = None,
    own_step: bool = False,
    threads: int = 0,
    progress: Progress = False,
    first_row: int = 0,
) -> Table:
    """Outcomes, and their exact derivatives, at very many points, on all processors.

    >>> import longdrive, numpy as np
    >>> loft = np.radians([8.0, 10.5, 13.0, np.nan])
    >>> table = longdrive.batch("tour-average", {"club.loft": loft, "swing.speed": "110 mph"}, of="carry", wrt="club.loft")
    >>> table.counts()
    {'landed': 3, 'out-of-range': 1}
    >>> table["carry"].shape, table.gradients.shape
    ((4,), (4, 1, 1))

    A row that cannot be flown is no exception but has a status. Rows are the same whatever the number of threads, and equal to those of ``longdrive sweep``.

    Args:
        setup: a setup, the name of a preset, or a dict.
        points: parameters with arrays of one length, shape (rows,), or numbers for all rows, in SI; a text carries its unit, and quantities of
            pint, and lists of them, are converted. 64-bit floats of any strides, also read-only ones, are not copied as a whole: 65 536 rows at a
            time are put in order.
        of: outcomes, a name or several; ``"all"`` for every one.
        wrt: parameters to differentiate by, a name or several; ``"points"`` for those of the points; without it no derivatives.
        hessians: whether second derivatives are computed too, without ``wrt`` those by the parameters of the points; they are those of the step
            that is chosen for all rows.
        tolerance: lengths are within it of their exact values, m or a text; without it 1 µm, unless the setup says how to integrate.
        own_step: whether ``flight.method`` and ``flight.step`` of the setup are kept.
        threads: how many; 0 for as many as there are processors that this process may use.
        progress: True for a bar, or a function of rows done and rows in all.
        first_row: the first row to compute, to go on after an interruption.

    Raises:
        InputError: for a name that nothing bears, or an array of the wrong shape or type.
        Interrupted: where Ctrl-C was pressed; it has the rows that were done.

    Warns:
        LongdriveWarning: once, with all of ``warnings`` of the table.
    """
    if switch_of("hessians", hessians) and wrt is None:
        wrt = "points"
    with interruptible("longdrive.batch was interrupted before the first row"), follower(
        "drives", progress
    ) as told:
        table = computed(
            setup,
            points,
            of,
            wrt,
            tolerance=tolerance,
            own_step=own_step,
            threads=threads,
            told=told,
            first_row=first_row,
            hessians=hessians,
        )
    warn_of(table.warnings, table, stacklevel=2)
    return table


def _without_units(setup: Setup, points: Any) -> Any:
    """The points with quantities of pint, or sequences of them, as numbers in SI: an array of NumPy would lose their unit."""
    if not isinstance(points, Mapping) or not any(
        is_quantity(values) or elements_of(values) is not None for values in points.values()
    ):
        return points
    units = {row["parameter"]: row["unit"] for row in _longdrive.parameters(setup)["parameters"]}

    def converted(name: str, values: Any) -> Any:
        elements = None if is_quantity(values) else elements_of(values)
        try:
            return (
                in_si(values, units[name])
                if elements is None
                else [in_si(value, units[name]) for value in elements]
            )
        except InputError as error:
            raise InputError(f"points: {name}: {error}") from None

    # of a name that nothing bears the batch says so
    return {
        name: converted(
            name, values
        ) if name in units else values for name, values in points.items()
    }


def _interrupted(after: int, whole: int) -> str:
    rest = (
        f"goes on, and Table.concatenate([table, rest]) joins both"
        if after < whole
        else "has nothing left to do"
    )
    return f"longdrive.batch was interrupted after {after} of {whole} rows, which `table` of this exception has; batch(…, first_row={after}) {rest}"


def computed(
    setup: SetupLike,
    points: Mapping[str, npt.ArrayLike | str],
    of: Names,
    wrt: Names | None,
    *,
    tolerance: float | str | None,
    own_step: bool,
    threads: int,
    told: Callable[[int, int], object] | None,
    first_row: int = 0,
    hessians: bool = False,
    ranges: list[tuple[str, float, float]] | None = None,
    interrupted: Callable[[int, int], str] = _interrupted,
) -> Table:
    """The table of a batch. The step is chosen for `ranges`, or for those of the points; `interrupted` says how one goes on after so many rows."""
    setup = setup if isinstance(setup, Setup) else Setup(setup)
    points, tolerance = _without_units(setup, points), in_si(tolerance, "m")
    if isinstance(tolerance, (bool, np.bool_)):
        raise InputError(
            f'tolerance = {tolerance!r}; expected a length, in m or as a text like "1 um"'
        )
    status, columns, seconds, of, by, given, units, warnings, (done, whole), raised = _longdrive.batch(setup, points, of, wrt, tolerance, switch_of("own_step", own_step), count_of("threads", threads), told, count_of("first_row", first_row), switch_of("hessians", hessians), ranges,)
    table = Table(
        status=status[:done],
        columns=columns[len(given) :, :done],
        points=columns[: len(given), :done],
        of=of,
        wrt=by,
        parameters=given,
        units=units,
        hessians=None if seconds is None else seconds[:done],
        first_row=first_row,
        warnings=warnings,
        setup=setup,
    )
    if raised is None:
        return table
    if isinstance(raised, KeyboardInterrupt):
        after = first_row + len(table)
        raise Interrupted(interrupted(after, whole), table) from raised
    raise raised
