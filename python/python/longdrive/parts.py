"""A sweep in parts, each a Parquet file whose bytes depend only on the sweep and
the number of the part.

Any process may compute any part, twice and in any order: the files are equal to the last bit, and
a file gets its name once it is complete. :mod:`longdrive.dask`, :mod:`longdrive.ray` and
:mod:`longdrive.spark` compute the parts on a cluster, :func:`sweep` in processes of this machine,
and ``longdrive sweep --part K/M`` in a job array.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Union

from . import _longdrive
from .angles import refuse_degrees_of_points
from .arguments import count_of, kind_of, path_of, refuse_idle_seed
from .errors import Error, InputError, Interrupted, warn_of
from .quantities import elements_of
from .sweeps import is_by_points

if TYPE_CHECKING:
    from concurrent.futures import Future

    from .conversion import Value
    from .types import Amount, AngleUnit, Given, Names, SetupLike

__all__ = ["Over", "PartError", "Parts", "SweepPlan", "check", "merge", "sweep"]

Over = Union[Mapping[str, "str | Sequence[float | str | int]"], Sequence[str]]
"""Ranges of a sweep: names with ``"LOW..HIGH:COUNT"`` or (low, high, count), numbers in SI. With
`sample`, a range has no count."""


class PartError(Error, RuntimeError):
    """A part that could not be written, even after all retries."""

    part: int
    """The number of the part, from 1."""

    def __init__(self, message: str, part: int) -> None:
        super().__init__(message)
        self.part = part

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.part))


class SweepPlan(NamedTuple):
    """A sweep in parts. It can be pickled, and any process may write any of its parts."""

    values: Mapping[str, Value]
    """The typed arguments of ``longdrive sweep``, without folder and part."""
    setup: str
    """The text of the setup file; empty for a preset."""
    output: str
    """The folder for the files of all workers."""
    parts: int
    """The number of parts."""
    threads: int = 1
    """The number of threads that compute a part."""
    stated: Sequence[str] = ()
    """The parameters that a dict in place of a setup states; a sweep refuses to vary them."""

    @property
    def words(self) -> tuple[str, ...]:
        """The command line of the sweep, without folder and part, for a job array."""
        return tuple(_longdrive.words_of("sweep", dict(self.values))[1:])

    @classmethod
    def of(
        cls,
        setup: SetupLike = None,
        *,
        output: str | os.PathLike[str],
        parts: int,
        over: Over = (),
        sample: int | None = None,
        seed: int | None = None,
        points: str | os.PathLike[str] | None = None,
        of: Names = "carry",
        wrt: Names | None = None,
        histogram: Given | None = None,
        highest: Mapping[str, int] | str | None = None,
        lowest: Mapping[str, int] | str | None = None,
        instructions: str | None = None,
        tolerance: Amount | None = None,
        own_step: bool = False,
        angles: AngleUnit = "rad",
        threads: int = 1,
    ) -> SweepPlan:
        """The sweep of a setup.

        Parameters
        ----------
        setup : SetupLike
            A setup, the name of a preset, or a dict.
        output : str | os.PathLike[str]
            The folder for the files; every worker must see it under this name.
        parts : int
            The number of parts; each has at least 1024 rows.
        over : Over
            Ranges: ``{"club.loft": "5deg..15deg:101"}``, or ``(low, high, count)`` with numbers in
            SI.
        sample : int | None
            The number of points of a quasi-random sequence in the ranges of `over`, which then have
            no counts.
        seed : int | None
            The seed of the sequence [default: 0].
        points : str | os.PathLike[str] | None
            A file with a table of points in place of `over`.
        of : Names
            Outcomes, a name or several; ``"all"`` for every one.
        wrt : Names | None
            Parameters to differentiate by, a name or several; ``"points"`` for the swept
            parameters; without it no derivatives.
        histogram : Given | None
            Outcomes with bins, ``{"carry": "200m..300m:64"}``, or ``(low, high, count)`` with
            numbers in SI.
        highest : Mapping[str, int] | str | None
            Outcomes with the number of rows of the highest values to keep, ``{"carry": 10}``.
        lowest : Mapping[str, int] | str | None
            Outcomes with the number of rows of the lowest values to keep.
        instructions : str | None
            ``"baseline"``, ``"avx2"``, ``"avx512"``, ``"neon"`` or ``"simd128"``, which the
            processor of every worker must have. Without it each worker uses its best, and parts of
            different processors are refused.
        tolerance : Amount | None
            The largest error of a length, m or a text like ``"1 mm"``; without it 1 µm.
        own_step : bool
            Keep ``flight.method`` and ``flight.step`` of the setup.
        angles : AngleUnit
            The unit of angles without a unit; ``"deg"`` is refused with `points`, whose columns
            have units.
        threads : int
            The number of threads that compute a part; a worker that computes several parts at a
            time uses this number for each.

        Returns
        -------
        SweepPlan
            The sweep.

        Raises
        ------
        InputError
            For an argument of the wrong type.

        Warns
        -----
        LongdriveWarning
            Of angles that were probably meant in degrees.

        Examples
        --------
        >>> from longdrive.parts import SweepPlan
        >>> over = {"club.loft": ("5 deg", "15 deg", 3000)}
        >>> SweepPlan.of("tour-average", output="drives", parts=2, over=over).parts
        2
        """
        # imported here: `import longdrive` does not need it
        from .request import Request

        count_of("parts", parts, 1)
        count_of("threads", threads, 1)
        refuse_idle_seed(seed, sample)
        if points is not None:
            refuse_degrees_of_points(angles)
        file = (
            None if points is None else path_of("points", points, "file that every worker can read")
        )
        request = Request(
            "sweep",
            {
                "setup": setup,
                "over": over or None,
                "sample": sample,
                "seed": seed,
                "points": file,
                "of": _joined("of", of),
                "gradient": is_by_points(wrt),
                "wrt": None if is_by_points(wrt) or wrt is None else _joined("wrt", wrt) or None,
                "histogram": histogram,
                "highest": _best("highest", highest),
                "lowest": _best("lowest", lowest),
                "instructions": instructions,
                "tolerance": tolerance,
                "own_step": own_step,
                "angles": angles,
            },
        )
        folder = path_of("output", output, "folder")
        plan = cls(request.values, request.setup_text, folder, parts, threads, request.stated)
        warn_of(request.warnings, plan)
        return plan

    def validate(self) -> None:
        """Checks the sweep without computing it.

        Raises
        ------
        InputError
            As :func:`longdrive.sweep` does.
        """
        # Parts need a folder. Name a file in its place: the command refuses it after all other
        # checks, before the first drive. So an error that names this file means: all else is right.
        name = "a file in memory"
        part = f"{self.parts}/{self.parts}"
        try:
            self._run({"output": name, "part": part}, {name: b""})
        except InputError as error:
            if name not in str(error):
                raise

    def write(self, part: int) -> dict[str, Any]:
        """Writes a part, from 1, unless it is complete already.

        Returns
        -------
        dict[str, Any]
            The row of the manifest for this part.

        Raises
        ------
        PartError
            If the part cannot be written; the message has the reason.

        Warns
        -----
        LongdriveWarning
            Of the drives of this part: the ``warnings`` of its row.
        """
        row = self._written(part)
        warn_of(row["warnings"], row)
        return row

    def _written(self, part: int) -> dict[str, Any]:
        """As :meth:`write`, without warnings, for workers: :meth:`Parts.of` warns of all parts."""
        file: dict[str, Value] = {
            "output": self.output, "part": f"{part}/{self.parts}", "threads": self.threads
        }
        try:
            answer = self._run(file)
        except Error as error:
            raise PartError(f"part {part} of {self.parts}: {error}", part) from error
        return {name: answer[name] for name in _MANIFEST}

    def check(self, *, contents: bool = False) -> dict[str, Any]:
        """Checks that the folder has every part of this sweep and nothing else: :func:`check`."""
        return check(self.output, contents=contents, plan=self)

    def _run(
        self, more: Mapping[str, Value], files: dict[str, bytes] | None = None
    ) -> dict[str, Any]:
        return _sweep({**self.values, **more}, self.setup, files, self.stated)


# fmt: skip
_MANIFEST = (
    "file",
    "bytes",
    "sha256",
    "part",
    "parts",
    "first_row",
    "rows",
    "question",
    "instructions",
    "data",
    "statuses",
    "beyond",
    "moments",
    "histograms",
    "best",
    "warnings",
)

_MOST_WARNINGS = 5
"""The largest number of warnings of parts that are shown."""


class Parts(NamedTuple):
    """A complete set of parts."""

    output: str
    """The folder."""
    manifests: list[dict[str, Any]]
    """A row for each part: its file with SHA-256, its number of rows, and their statistics."""
    summary: dict[str, Any]
    """Statistics of all rows: ``statuses``, ``moments``, ``histograms``, ``best``."""

    def __repr__(self) -> str:
        return f"Parts(output={self.output!r})"

    @property
    def rows(self) -> int:
        """The number of rows of all parts."""
        return sum(row["rows"] for row in self.manifests)

    @classmethod
    def of(cls, plan: SweepPlan, rows: Iterable[dict[str, Any]]) -> Parts:
        """Checks the folder, and returns its parts; `rows` are their rows of the manifest.

        Raises
        ------
        Error
            For a missing part, and a wrong file in the folder.

        Warns
        -----
        LongdriveWarning
            Once, with the first warnings of the parts. The rows of ``manifests`` have all.
        """
        manifests = sorted(rows, key=lambda row: int(row["part"]))
        found = plan.check()
        if found["status"] != "done":
            raise Error(f"{plan.output}: {found['message']}")
        parts = cls(plan.output, manifests, merge(manifests))
        warn_of(_warnings_of(manifests), parts)
        return parts


def _warnings_of(manifests: Iterable[Mapping[str, Any]]) -> list[str]:
    """The first warnings of the parts, and the number of all others."""
    texts = [
        f"part {row['part']} of {row['parts']}: {text}"
        for row in manifests
        for text in row.get("warnings", ())
    ]
    more = len(texts) - _MOST_WARNINGS
    if more <= 0:
        return texts
    return [*texts[:_MOST_WARNINGS], f"… and {more} more in the rows of `manifests`"]


def _sweep(
    values: Mapping[str, Value],
    setup: str,
    files: dict[str, bytes] | None = None,
    stated: Sequence[str] = (),
) -> dict[str, Any]:
    """Runs ``longdrive sweep`` and returns its answer.

    `files` are files in memory, `stated` the parameters that a dict in place of a setup states.
    """
    status, answer, _, raised = _longdrive.command(
        "sweep", dict(values), setup, files or {}, [], lambda kind, text: None, None, list(stated)
    )
    if raised is not None:
        has_message = isinstance(answer, dict) and answer["message"]
        reason = answer["message"] if has_message else "interrupted before there was an answer"
        raise Interrupted(reason) from raised
    if status == 2:
        raise InputError(answer["message"])
    found: dict[str, Any] = answer
    return found


def _best(name: str, rows: Mapping[str, int] | str | None) -> list[str] | None:
    """The outcomes with the number of rows to keep for each, as texts such as ``carry:10``."""
    if isinstance(rows, str):
        return [rows]
    if rows is None:
        return None
    if not isinstance(rows, Mapping):
        raise InputError(
            f"{name} is {kind_of(rows)}; expected a dict of outcomes with their number of rows, as "
            "in {'carry': 10}"
        )
    return [f"{of}:{count_of(f'{name} of {of}', count, 1)}" for of, count in rows.items()]


def _joined(name: str, names: Names) -> str:
    parts = (names,) if isinstance(names, str) else elements_of(names)
    if parts is None:
        raise InputError(f"{name} is {kind_of(names)}; expected a name or a list of names")
    for at, part in enumerate(parts):
        if not isinstance(part, str):
            raise InputError(f"{name}[{at}] is {kind_of(part)}; expected a name")
    return ",".join(parts)


def plan_of(setup: SetupLike, arguments: Mapping[str, Any]) -> SweepPlan:
    """Checks the arguments of a function that sends parts to workers, and returns the sweep.

    Raises
    ------
    InputError
        For a bad argument, before any work is sent.
    """
    missing = [name for name in ("output", "parts") if name not in arguments]
    if missing:
        raise InputError(
            f"a sweep in parts needs {' and '.join(missing)}: the folder of the files, and the "
            "number of parts"
        )
    found = SweepPlan.of(setup, **arguments)
    found.validate()
    # an absolute path: workers may have been started in other folders
    return found._replace(output=os.path.abspath(found.output))


def check(
    output: str | os.PathLike[str], *, contents: bool = False, plan: SweepPlan | None = None
) -> dict[str, Any]:
    """Checks the footers of the files in a folder: the answer of ``longdrive sweep --check``.

    ``status`` is ``"done"`` if every part exists and nothing else; otherwise ``missing``,
    ``faults`` and ``message`` have the reason.

    Parameters
    ----------
    output : str | os.PathLike[str]
        The folder.
    contents : bool
        Read the rows too, and compare them with the SHA-256 of each part; ``sha256`` is then the
        hash of the whole set.
    plan : SweepPlan | None
        The sweep to which the parts must belong.

    Returns
    -------
    dict[str, Any]
        The answer.

    Examples
    --------
    >>> import longdrive.parts, tempfile
    >>> over = {"club.loft": "5deg..15deg:3000"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     plan = longdrive.parts.SweepPlan.of(over=over, of="spin", output=folder, parts=2)
    ...     written = plan.write(1)
    ...     longdrive.parts.check(folder)["missing"]
    [2]
    """
    options: dict[str, Value] = {"check": os.fspath(output), "hash": contents}
    if plan is None:
        return _sweep({"json": True, **options}, "")
    return plan._run(options)


def merge(manifests: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Statistics of the rows of several parts, from their rows of the manifest.

    The statistics have ``statuses``, ``moments`` (``count``, ``mean``, ``m2``, the sum of squared
    deviations, ``min`` and ``max`` of each column, SI), ``histograms`` and ``best`` rows. The parts
    are merged in the order of their numbers, each once: the result does not depend on the order of
    the rows.

    Parameters
    ----------
    manifests : Iterable[Mapping[str, Any]]
        Rows of the manifest, as ``Parts.manifests``.

    Returns
    -------
    dict[str, Any]
        The statistics.

    Raises
    ------
    InputError
        For the name of a folder, and for rows that are not rows of a manifest.
    """
    import json

    if isinstance(manifests, (str, os.PathLike)):
        raise InputError(
            f"manifests is {kind_of(manifests)}; expected the `manifests` of parts; "
            "longdrive.parts.check checks and describes a folder"
        )

    def finite(value: Any) -> Any:
        # JSON has no infinity
        if isinstance(value, float) and not math.isfinite(value):
            return "inf" if value > 0 else "-inf"
        if isinstance(value, Mapping):
            return {name: finite(item) for name, item in value.items()}
        return [finite(item) for item in value] if isinstance(value, list) else value

    merged: dict[str, Any] = _longdrive.merge_parts(json.dumps([finite(row) for row in manifests]))
    return merged


def sweep(
    setup: SetupLike = None, *, processes: int = 0, retries: int = 3, **arguments: Any
) -> Parts:
    """Computes all parts in processes of this machine.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    processes : int
        The number of processes; 0 for the number of processors.
    retries : int
        How often a part is tried again, after an error or the death of its process.
    arguments : Any
        As :meth:`SweepPlan.of`: `output`, `parts`, `over`, `of`, `wrt`, …

    Returns
    -------
    Parts
        The parts.

    Raises
    ------
    PartError
        For a part that could not be written.
    InputError
        For bad arguments.
    Interrupted
        After Ctrl-C; complete parts stay, and the same call continues.

    Examples
    --------
    >>> import longdrive.parts, tempfile
    >>> over = {"club.loft": "5deg..15deg:3000"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = longdrive.parts.sweep(
    ...         over=over, of="ball_speed", output=folder, parts=2, processes=1)
    >>> found.rows, found.summary["statuses"]["landed"]
    (3000, 3000)
    """
    from concurrent.futures.process import BrokenProcessPool

    count_of("processes", processes)
    count_of("retries", retries)
    plan = plan_of(setup, arguments)
    manifests: dict[int, dict[str, Any]] = {}
    tries = dict.fromkeys(range(1, plan.parts + 1), 0)
    while len(manifests) < plan.parts:
        # the death of a process ends the pool: another pool computes the missing parts
        left = [part for part in tries if part not in manifests]
        try:
            _in_processes(plan, left, tries, manifests, processes or os.cpu_count() or 1, retries)
        except KeyboardInterrupt as raised:
            done = f"{len(manifests)} of {plan.parts} parts are complete in {plan.output}"
            raise Interrupted(
                f"longdrive.parts.sweep was interrupted: {done}; the same call writes the others"
            ) from raised
        except BrokenProcessPool as error:
            part = next(part for part in tries if part not in manifests)
            tries[part] += 1
            if tries[part] > retries:
                raise PartError(
                    f"part {part} of {plan.parts}: its process died, {retries + 1} times", part
                ) from error
    return Parts.of(plan, manifests.values())


def _in_processes(
    plan: SweepPlan,
    left: list[int],
    tries: dict[int, int],
    manifests: dict[int, dict[str, Any]],
    processes: int,
    retries: int,
) -> None:
    # imported here: `import longdrive` does not need them
    from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
    from multiprocessing import get_context

    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        waiting = iter(left)
        running: dict[Future[dict[str, Any]], int] = {}

        def begin(part: int | None) -> None:
            if part is not None:
                running[pool.submit(plan._written, part)] = part

        for _ in range(2 * processes):
            begin(next(waiting, None))
        while running:
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                part = running.pop(future)
                try:
                    manifests[part] = future.result()
                    begin(next(waiting, None))
                except PartError:
                    tries[part] += 1
                    if tries[part] > retries:
                        pool.shutdown(cancel_futures=True)
                        raise
                    begin(part)
