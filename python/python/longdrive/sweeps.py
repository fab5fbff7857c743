"""Sweeps over grids, quasi-random sequences and tables of points, into memory or a file."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Union, overload

from . import _longdrive
from .angles import refuse_degrees_of_points
from .arguments import count_of, refuse_idle_seed, switch_of
from .batches import computed
from .errors import InputError, interruptible, warn_of
from .progress import follower
from .quantities import elements_of
from .replies import SweepReply
from .reply import as_reply
from .run_command import run_command
from .setups import CallSetup
from .table import Table
from .tables import points_in_si

if TYPE_CHECKING:
    from .progress import Progress
    from .types import Amount, AngleUnit, Given, Names, PathLike, SetupLike, TableLike

__all__ = ["is_by_points", "sweep"]


@overload
def sweep(
    setup: SetupLike = None,
    over: Given | None = None,
    *,
    sample: int | None = None,
    seed: int | None = None,
    points: TableLike | None = None,
    of: Names = "carry",
    wrt: Names | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    angles: AngleUnit = "rad",
    threads: int = 0,
    output: None = None,
    progress: Progress = False,
) -> Table: ...


@overload
def sweep(
    setup: SetupLike = None,
    over: Given | None = None,
    *,
    sample: int | None = None,
    seed: int | None = None,
    points: TableLike | None = None,
    of: Names = "carry",
    wrt: Names | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    angles: AngleUnit = "rad",
    threads: int = 0,
    output: PathLike,
    resume: bool = False,
    overwrite: bool = False,
    progress: Progress = False,
) -> SweepReply: ...


def sweep(
    setup: SetupLike = None,
    over: Given | None = None,
    *,
    sample: int | None = None,
    seed: int | None = None,
    points: TableLike | None = None,
    of: Names = "carry",
    wrt: Names | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    angles: AngleUnit = "rad",
    threads: int = 0,
    output: PathLike | None = None,
    resume: bool = False,
    overwrite: bool = False,
    progress: Progress = False,
) -> Union[Table, SweepReply]:
    """Very many drives at the points of a grid, a quasi-random sequence or a table.

    The rows equal the rows of ``longdrive sweep``, to the last bit.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    over : Given | None
        Parameters with tuples (low, high, count), numbers in SI, or texts such as
        ``"5deg..15deg:101"``; the last parameter changes fastest. With `sample`, tuples (low,
        high).
    sample : int | None
        The number of points of a quasi-random (Sobol') sequence in the ranges of `over`.
    seed : int | None
        The seed of the sequence [default: 0].
    points : TableLike | None
        A table of points in place of `over`: a file, a dict of columns, a table of pandas, polars
        or pyarrow, or a :class:`Table`, whose points are taken. The head of a column names its
        unit, as ``club.loft [deg]``.
    of : Names
        Outcomes, a name or several; ``"all"`` for every one.
    wrt : Names | None
        Parameters to differentiate by, a name or several; ``"points"`` for the swept
        parameters; without it no derivatives.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.
    angles : AngleUnit
        The unit of angles without a unit; ``"deg"`` is refused with `points`, whose columns have
        units.
    threads : int
        The number of threads; 0 for the number of processors of this process.
    output : PathLike | None
        A file (.csv, .jsonl, .parquet) for the rows, written as they are computed; without it the
        function returns them as a table.
    resume : bool
        Continue an unfinished file.
    overwrite : bool
        Replace a file that exists.
    progress : Progress
        True for a bar, or a function of the rows done and all rows.

    Returns
    -------
    Union[Table, SweepReply]
        The rows; with `output`, a summary.

    Raises
    ------
    InputError
        For bad input.
    Interrupted
        After Ctrl-C: for a table, with the rows that were done; for a file, `resume` continues.

    Warns
    -----
    LongdriveWarning
        Once, with all ``warnings`` of the table or the summary.

    Examples
    --------
    >>> import longdrive
    >>> over = {"club.loft": ("8 deg", "12 deg", 5), "swing.speed": (45.0, 50.0, 3)}
    >>> table = longdrive.sweep("tour-average", over, wrt="points")
    >>> len(table), table.wrt
    (15, ('club.loft', 'swing.speed'))
    """
    if points is not None:
        refuse_degrees_of_points(angles)
    _refuse(
        over,
        sample,
        seed,
        points,
        output,
        switch_of("resume", resume) or switch_of("overwrite", overwrite),
    )
    given: dict[str, Any] = {
        "setup": setup,
        "over": over,
        "sample": sample,
        "seed": seed,
        "points": points,
        "angles": angles,
    }
    if output is not None:
        by = {"gradient": True} if is_by_points(wrt) else {"wrt": wrt}
        file = {
            "of": of,
            "tolerance": tolerance,
            "own_step": own_step,
            "threads": threads,
            "output": os.fspath(output),
            "resume": resume,
            "overwrite": overwrite,
            "progress": progress,
        }
        return run_command("sweep", {**given, **by, **file}, as_reply(SweepReply))
    with interruptible("longdrive.sweep was interrupted before the first row"):
        call = CallSetup.of(setup, angles)
        at, ranges, warnings = _points({**given, "setup": call.setup})
        call.refuse_idle(at)
        with follower("sweep", progress) as show:
            table = computed(
                call.setup,
                at,
                of,
                wrt,
                tolerance=tolerance,
                own_step=own_step,
                threads=threads,
                show=show,
                ranges=ranges,
                interrupted=_interrupted,
            )
    table.warnings[:0] = [*call.warnings_of_drive, *warnings]
    warn_of(table.warnings, table)
    return table


def is_by_points(wrt: Names | None) -> bool:
    """True if `wrt` means the swept parameters: ``"points"``, also as the only element of a list.

    Then the command has ``--gradient`` in place of ``--wrt``.
    """
    if isinstance(wrt, str):
        return wrt == "points"
    return hasattr(wrt, "__len__") and elements_of(wrt) == ("points",)


def _points(
    given: dict[str, Any],
) -> tuple[dict[str, Any], list[tuple[str, float, float]] | None, list[str]]:
    """The points of a sweep by parameter, their ranges, and warnings about the arguments and the
    columns."""
    in_si = points_in_si(given["points"])
    if in_si is not None:
        return in_si, None, []
    # imported here: `import longdrive` does not need it
    from .request import Request

    request = Request("sweep", {name: given[name] for name in given if name != "sample"})
    over = request.texts("over")
    if given["sample"] is not None:
        _refuse_counts(over)
    table = request.values.get("points")
    assert table is None or isinstance(table, str)
    at, ranges, notes = _longdrive.plan(
        given["setup"],
        over,
        given["sample"],
        given["seed"] or 0,
        table,
        request.files,
        request.bare_angles,
    )
    return at, ranges, [*request.warnings, *notes]


def _interrupted(after: int, whole: int) -> str:
    return (
        f"longdrive.sweep was interrupted after {after} of {whole} rows, which are in `table` of "
        "this exception; the same call begins again; a call with output=FILE keeps its rows, and "
        "goes on with resume=True"
    )


def _refuse_counts(over: list[str]) -> None:
    """Refuses ranges with a count if there is a sample, because the sample has its own count."""
    counted = next((text for text in over if ":" in text), None)
    if counted is not None:
        without = counted.rpartition(":")[0]
        raise InputError(
            f"the range {counted}: sample says how many points there are; write {without}, or "
            "(low, high), without a count"
        )


def _refuse(
    over: Given | None,
    sample: int | None,
    seed: int | None,
    points: TableLike | None,
    output: PathLike | None,
    is_of_file: bool,
) -> None:
    """Refuses two arguments if one of them would make the other ineffective."""
    if points is not None and over is not None:
        raise InputError("over and points both say what is swept; keep one of the two")
    if points is not None and sample is not None:
        raise InputError(
            "sample and points both choose the points of the sweep: sample takes them from the "
            "ranges in over, points lists them; keep one of the two"
        )
    if over is None and points is None:
        raise InputError(
            'nothing to sweep: give over, as in over={"club.loft": ("5 deg", "15 deg", 101)}, or '
            "points"
        )
    if sample is not None:
        count_of("sample", sample, 1)
    refuse_idle_seed(seed, sample)
    if output is None and is_of_file:
        raise InputError(
            "resume and overwrite are about a file; name one with output, or leave both out"
        )
