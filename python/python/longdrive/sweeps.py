"""Sweeps: grids, quasi-random sequences and tables of points, into memory or into a file."""

from __future__ import annotations

import os
from typing import Union, overload

from . import _longdrive
from ._ask import ask
from ._longdrive import Setup
from ._question import Question
from .arguments import count_of, refuse_idle_seed, switch_of
from .batches import computed
from .errors import InputError, interruptible, warn_of
from .progress import Progress, follower
from .reply import Reply, as_reply
from .table import Table
from .types import Amount, Given, Names, PathLike, SetupLike, TableLike

__all__ = ["sweep"]


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
    threads: int = 0,
    output: PathLike,
    resume: bool = False,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply: ...


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
    threads: int = 0,
    output: PathLike | None = None,
    resume: bool = False,
    overwrite: bool = False,
    progress: Progress = False,
) -> Union[Table, Reply]:
    """Very many drives: the points of a grid, a quasi-random sequence or a table; the rows of ``longdrive sweep``, to the last bit.

    >>> import longdrive
    >>> table = longdrive.sweep("tour-average", {"club.loft": ("8 deg", "12 deg", 5), "swing.speed": (45.0, 50.0, 3)}, wrt="points")
    >>> len(table), table.wrt
    (15, ('club.loft', 'swing.speed'))

    Args:
        setup: a setup, the name of a preset, or a dict.
        over: parameters with tuples (low, high, count), numbers in SI, or a text like ``"5deg..15deg:101"``; the last changes fastest. With `sample`
            (low, high).
        sample: so many points of a quasi-random (Sobol') sequence in the ranges of `over`.
        seed: another seed gives other points of the sample [default: 0].
        points: a table of points in place of `over`: a file, a dict of columns, or a table of pandas, polars or pyarrow.
        of: outcomes, a name or several; ``"all"`` for every one.
        wrt: parameters to differentiate by, a name or several; ``"points"`` for those that are swept; without it no derivatives.
        tolerance: lengths are within it of their exact values, m or a text; without it 1 µm, unless the setup says how to integrate.
        own_step: whether ``flight.method`` and ``flight.step`` of the setup are kept.
        threads: how many; 0 for as many as there are processors that this process may use.
        output: a file (.csv, .jsonl, .parquet) that the rows are written into as they are computed; without it they are returned as a table.
        resume: whether a file that was left unfinished is gone on with.
        overwrite: whether a file that exists is replaced.
        progress: True for a bar, or a function of rows done and rows in all.

    Raises:
        InputError: bad input, with the program's message.
        Interrupted: where Ctrl-C was pressed: of a table with the rows that were done; a file is gone on with by `resume`.

    Warns:
        LongdriveWarning: once, with all of ``warnings`` of the table or the reply.
    """
    _refuse(
        over,
        sample,
        seed,
        points,
        output,
        switch_of("resume", resume) or switch_of("overwrite", overwrite),
    )
    if output is not None:
        by = {"gradient": True} if wrt == "points" else {"wrt": wrt}
        file = {
            "output": os.fspath(output),
            "resume": resume,
            "overwrite": overwrite,
            "progress": progress,
        }
        given = {
            "setup": setup,
            "over": over,
            "sample": sample,
            "seed": seed,
            "points": points,
            "of": of,
            **by,
        }
        return ask(
            "sweep",
            {**given, "tolerance": tolerance, "own_step": own_step, "threads": threads, **file},
            as_reply,
        )
    import tempfile  # `import longdrive` does not wait for these
    from pathlib import Path

    with interruptible(
        "longdrive.sweep was interrupted before the first row"
    ), tempfile.TemporaryDirectory(prefix="longdrive-") as name:
        question = Question("sweep", Path(name))
        question.setup = setup if isinstance(setup, Setup) else Setup(setup)
        table = None if points is None else question.file("points", points)
        with question.named():
            ranges_asked = question.texts("over", over)
            if sample is not None:
                _refuse_counts(ranges_asked)
            at, ranges = _longdrive.plan(question.setup, ranges_asked, sample, seed or 0, table)
        with follower("sweep", progress) as told:
            found = computed(
                question.setup,
                at,
                of,
                wrt,
                tolerance=tolerance,
                own_step=own_step,
                threads=threads,
                told=told,
                ranges=ranges,
                interrupted=_interrupted,
            )
    warn_of(found.warnings, found, stacklevel=2)
    return found


def _interrupted(after: int, whole: int) -> str:
    return (
        f"longdrive.sweep was interrupted after {after} of {whole} rows, which `table` of this exception has; the same call begins again; one with " "output=FILE keeps its rows, and goes on with resume=True"
    )


def _refuse_counts(over: list[str]) -> None:
    """Ranges with a count, where a sample says how many points there are."""
    counted = next((text for text in over if ":" in text), None)
    if counted is not None:
        without = counted.rpartition(":")[0]
        raise InputError(
            f"the range {counted}: sample says how many points there are; write {without}, or (low, high), without a count"
        )


def _refuse(
    over: Given | None,
    sample: int | None,
    seed: int | None,
    points: TableLike | None,
    output: PathLike | None,
    is_of_file: bool,
) -> None:
    """Arguments of which one would leave another without effect."""
    if points is not None and over is not None:
        raise InputError("over and points both say what is swept; keep one of the two")
    if points is not None and sample is not None:
        raise InputError(
            "sample takes points in the ranges of over, and points has its own; keep one of the two"
        )
    if over is None and points is None:
        raise InputError(
            'nothing to sweep: give over, as in over={"club.loft": ("5 deg", "15 deg", 101)}, or points'
        )
    if sample is not None:
        count_of("sample", sample, 1)
    refuse_idle_seed(seed, sample)
    if output is None and is_of_file:
        raise InputError(
            "resume and overwrite are about a file; name it with output, or leave them out"
        )
