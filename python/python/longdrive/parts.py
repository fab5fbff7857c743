"""A sweep divided into parts, each a Parquet file whose bytes follow from the question and its number alone.

Any engine may compute any part, twice and in any order: the files are the same to the last bit, and a file takes its place once it is whole.
:mod:`longdrive.dask`, :mod:`longdrive.ray` and :mod:`longdrive.spark` do it on a cluster, :func:`sweep` of this module in processes of
this machine, and ``longdrive sweep --part K/M`` from a job array.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, field, replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Union

from . import _longdrive
from ._question import Question as Words
from .arguments import count_of, kind_of, path_of, refuse_idle_seed
from .errors import Error, InputError, Interrupted
from .types import Amount, Given, Names, SetupLike
from .written import parts_of

__all__ = ["Over", "PartError", "Parts", "Question", "check", "merge", "sweep"]

Over = Union[Mapping[str, "str | Sequence[float | str | int]"], Sequence[str]]
"""What is swept: names with ``"LOW..HIGH:COUNT"`` or (low, high, count), numbers in SI; with `sample` without the count."""


class PartError(Error, RuntimeError):
    """A part that could not be written, however often it was tried. ``part`` is its number, from 1."""

    part: int

    def __init__(self, message: str, part: int) -> None:
        super().__init__(message)
        self.part = part

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.part))


@dataclass(frozen=True)
class Question:
    """A sweep that is divided into parts; it pickles, and any process may write any of its parts."""

    words: tuple[str, ...]
    """The command line of ``longdrive sweep``, without folder and part."""
    setup: str
    """The setup, as the text of a setup file, where it is no preset."""
    output: str
    """The folder that every worker writes into."""
    parts: int
    """How many there are."""
    threads: int = 1
    """Threads that compute a part."""

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
        threads: int = 1,
    ) -> Question:
        """The sweep of a setup.

        Args:
            setup: a setup, the name of a preset, or a dict.
            output: the folder for the files; every worker must see it under this name.
            parts: how many; each has at least 1024 rows.
            over: what is swept: ``{"club.loft": "5deg..15deg:101"}``, or ``(low, high, count)`` with numbers in SI.
            sample: so many points of a quasi-random sequence in the ranges of `over`, which then have no counts.
            seed: another seed gives other points of the sample [default: 0].
            points: a table of points in place of `over`.
            of: outcomes, a name or several; ``"all"`` for every one.
            wrt: parameters to differentiate by, a name or several; ``"points"`` for those that are swept; without it no derivatives.
            histogram: outcomes with bins, ``{"carry": "200m..300m:64"}``, or ``(low, high, count)`` with numbers in SI.
            highest: outcomes with how many rows of the highest values to keep by themselves, ``{"carry": 10}``.
            lowest: the same of the lowest.
            instructions: ``"baseline"``, ``"avx2"``, ``"avx512"``, ``"neon"`` or ``"simd128"``: what every worker's processor has. Without it each takes the most it has, and
                parts of different processors are refused.
            tolerance: lengths are within it of their exact values, m or a text like ``"1 mm"``; without it 1 µm.
            own_step: whether ``flight.method`` and ``flight.step`` of the setup are kept.
            threads: threads that compute a part; a worker that computes several parts at a time has one for each.
        """
        count_of("parts", parts, 1)
        count_of("threads", threads, 1)
        folder = path_of("output", output, "folder")
        file = (
            None if points is None else path_of("points", points, "file that every worker can read")
        )
        asked = Words("sweep", Path())
        asked.take_setup(setup)
        asked.option("over", over or None, "several", "NAME=LOW..HIGH:COUNT")
        asked.option("sample", sample, "one", "N")
        refuse_idle_seed(seed, sample)
        asked.option("seed", seed, "one", "SEED")
        asked.option("points", file, "one", "FILE")
        asked.option("outcomes", _joined("of", of), "one", "OUTCOMES", "of")
        if wrt == "points":
            asked.option("gradient", True, "nothing", "GRADIENT")
        else:
            asked.option("wrt", _joined("wrt", () if wrt is None else wrt) or None, "one", "NAMES")
        asked.option("histogram", histogram, "several", "OUTCOME=LOW..HIGH:COUNT")
        asked.option("highest", _best("highest", highest), "several", "OUTCOME:ROWS")
        asked.option("lowest", _best("lowest", lowest), "several", "OUTCOME:ROWS")
        asked.option("instructions", instructions, "one", "LEVEL")
        asked.option("tolerance", tolerance, "one", "LENGTH")
        asked.option("own_step", own_step, "nothing", "OWN_STEP")
        return cls(tuple(asked.words), asked.text, folder, parts, threads)

    def refuse_unsound(self) -> None:
        """Asks the question without computing anything, so that what is wrong with it is told before there are workers.

        Raises:
            InputError: as :func:`longdrive.sweep` does.
        """
        import tempfile

        # the program looks at the folder after the question, and before the first drive: a file in its place ends the work there
        with tempfile.NamedTemporaryFile(prefix="longdrive-") as file:
            try:
                _sweep(
                    [*self.words, f"--output={file.name}", f"--part={self.parts}/{self.parts}"],
                    self.setup,
                )
            except InputError as error:
                if file.name not in str(error):
                    raise

    def write(self, part: int) -> dict[str, Any]:
        """Writes a part, from 1, unless it is there already; its manifest row.

        Raises:
            PartError: with why it could not be written.
        """
        words = [
            *self.words,
            f"--output={self.output}",
            f"--part={part}/{self.parts}",
            f"--threads={self.threads}",
        ]
        try:
            answer = _sweep(words, self.setup)
        except Error as error:
            raise PartError(f"part {part} of {self.parts}: {error}", part) from error
        return {name: answer[name] for name in _MANIFEST}

    def check(self, *, contents: bool = False) -> dict[str, Any]:
        """Looks whether the folder has every part of this sweep and nothing else, as :func:`check` does."""
        return check(self.output, contents=contents, question=self)


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
)


@dataclass(frozen=True)
class Parts:
    """A complete set of parts."""

    output: str
    """The folder."""
    manifests: list[dict[str, Any]] = field(repr=False)
    """A row for each part, in their order: its file with SHA-256, its rows, and what they are like."""
    summary: dict[str, Any] = field(repr=False)
    """What all rows are like: ``statuses``, ``moments``, ``histograms``, ``best``."""

    @property
    def rows(self) -> int:
        """Rows of all parts."""
        return sum(row["rows"] for row in self.manifests)

    @classmethod
    def of(cls, question: Question, rows: Iterable[dict[str, Any]]) -> Parts:
        """The set, of the manifest rows of all its parts.

        Raises:
            Error: where a part is missing, or a file of the folder is not what it should be.
        """
        manifests = sorted(rows, key=lambda row: int(row["part"]))
        found = question.check()
        if found["status"] != "done":
            raise Error(f"{question.output}: {found['message']}")
        return cls(question.output, manifests, merge(manifests))


def _sweep(words: list[str], setup: str) -> dict[str, Any]:
    """The answer of ``longdrive sweep``; what the program warns of stands in it."""
    status, answer, raised = _longdrive.command([*words, "--quiet"], setup, lambda kind, text: None)
    if raised is not None:
        why = (
            answer["message"] if isinstance(answer, dict)
            and answer["message"] else "interrupted before there was an answer"
        )
        raise Interrupted(why) from raised
    if status == 2:
        raise InputError(answer["message"])
    found: dict[str, Any] = answer
    return found


def _best(name: str, rows: Mapping[str, int] | str | None) -> list[str]:
    """Outcomes with their number of rows, as the program has them; a text as it is."""
    if isinstance(rows, str):
        return [rows]
    if not (rows is None or isinstance(rows, Mapping)):
        raise InputError(
            f"{name} is {kind_of(rows)}; expected a dict of outcomes with their number of rows, as in {{'carry': 10}}"
        )
    return [f"{of}:{count_of(f'{name} of {of}', count, 1)}" for of, count in (rows or {}).items()]


def _joined(name: str, names: Names) -> str:
    parts = (names,) if isinstance(names, str) else parts_of(names)
    if parts is None:
        raise InputError(f"{name} is {kind_of(names)}; expected a name or several")
    for at, part in enumerate(parts):
        if not isinstance(part, str):
            raise InputError(f"{name}[{at}] is {kind_of(part)}; expected a name")
    return ",".join(parts)


def question_of(setup: SetupLike, question: Mapping[str, Any]) -> Question:
    """A sound question, of the arguments of a function that sends its parts to workers.

    Raises:
        InputError: for what is wrong with it, before any work is sent.
    """
    missing = [name for name in ("output", "parts") if name not in question]
    if missing:
        raise InputError(
            f"a sweep in parts needs {' and '.join(missing)}: the folder of the files, and how many there are"
        )
    found = Question.of(setup, **question)
    found.refuse_unsound()
    # workers may have been started in other folders
    return replace(found, output=os.path.abspath(found.output))


def check(
    output: str | os.PathLike[str], *, contents: bool = False, question: Question | None = None
) -> dict[str, Any]:
    """Looks through the footers of a folder of parts: the answer of ``longdrive sweep --check``.

    ``status`` is ``"done"`` where every part is there and nothing else; ``missing``, ``faults`` and ``message`` say what is not as it should be.

    Args:
        output: the folder.
        contents: whether the rows are read too, held against the SHA-256 of each part; ``sha256`` is then that of the whole set.
        question: the sweep that the parts are to be of.
    """
    options = [f"--check={os.fspath(output)}"] + (["--hash"] if contents else [])
    if question is None:
        return _sweep(["sweep", "--json", *options], "")
    return _sweep([*question.words, *options], question.setup)


def merge(manifests: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """What the rows of some parts are like in all, without a look at the rows: ``statuses``, ``moments`` (``count``, ``mean``, ``m2``, the sum of
    squared deviations, ``min`` and ``max`` of each column, SI), ``histograms`` and ``best`` rows.

    The parts are merged in the order of their numbers, each once, so that the result is the same to the last bit whatever the order they came in.
    """

    if isinstance(manifests, (str, os.PathLike)):
        raise InputError(
            f"manifests is {kind_of(manifests)}; expected the `manifests` of parts; longdrive.parts.check tells of a folder what its rows are like"
        )

    def finite(value: Any) -> Any:
        # JSON has no infinity: a flat face is "inf"
        if isinstance(value, float) and not math.isfinite(value):
            return "inf" if value > 0 else "-inf"
        if isinstance(value, Mapping):
            return {name: finite(item) for name, item in value.items()}
        return [finite(item) for item in value] if isinstance(value, list) else value

    merged: dict[str, Any] = _longdrive.merge_parts(json.dumps([finite(row) for row in manifests]))
    return merged


def sweep(
    setup: SetupLike = None, *, processes: int = 0, retries: int = 3, **question: Any
) -> Parts:
    """Computes all parts in processes of this machine.

    >>> import longdrive.parts, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = longdrive.parts.sweep(
    ...         over={"club.loft": "5deg..15deg:3000"}, of="ball_speed", output=folder, parts=2, processes=1)
    >>> found.rows, found.summary["statuses"]["landed"]
    (3000, 3000)

    Args:
        setup: a setup, the name of a preset, or a dict.
        processes: how many; 0 for as many as there are processors.
        retries: how often a part is tried again, after an error or the death of its process.
        question: as :meth:`Question.of`: `output`, `parts`, `over`, `of`, `wrt`, …

    Raises:
        PartError: for a part that could not be written.
        InputError: for arguments that are none.
        Interrupted: after Ctrl-C; parts that are whole stay, and the same call goes on.
    """
    count_of("processes", processes)
    count_of("retries", retries)
    asked = question_of(setup, question)
    manifests: dict[int, dict[str, Any]] = {}
    tries = dict.fromkeys(range(1, asked.parts + 1), 0)
    while len(manifests) < asked.parts:
        # a process that dies takes the pool with it: what is not done then is begun again in another
        left = [part for part in tries if part not in manifests]
        try:
            _in_processes(asked, left, tries, manifests, processes or os.cpu_count() or 1, retries)
        except KeyboardInterrupt as raised:
            done = f"{len(manifests)} of {asked.parts} parts are known to be whole in {asked.output}"
            raise Interrupted(
                f"longdrive.parts.sweep was interrupted: {done}; the same call writes those that are missing"
            ) from raised
        except BrokenProcessPool as error:
            part = next(part for part in tries if part not in manifests)
            tries[part] += 1
            if tries[part] > retries:
                raise PartError(
                    f"part {part} of {asked.parts}: its process died, {retries + 1} times", part
                ) from error
    return Parts.of(asked, manifests.values())


def _in_processes(
    asked: Question,
    left: list[int],
    tries: dict[int, int],
    manifests: dict[int, dict[str, Any]],
    processes: int,
    retries: int,
) -> None:
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        waiting = iter(left)
        running: dict[Future[dict[str, Any]], int] = {}

        def begin(part: int | None) -> None:
            if part is not None:
                running[pool.submit(asked.write, part)] = part

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
