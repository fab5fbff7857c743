"""Progress of long work, in notebooks and terminals."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

from .arguments import switch_of

__all__ = ["Bar", "Progress", "follower"]

Show = Callable[[int, int], Any]

Progress = Union[bool, Show, None]
"""True for a bar (by tqdm, if it is installed, also in notebooks), or a function that is called with
the number of parts done and the number of all parts, 0 and 0 while the parts cannot be counted.
None means False."""


@contextmanager
def follower(doing: str, progress: Progress) -> Iterator[Show | None]:
    """The function that shows the progress of some work; None without progress.

    Raises
    ------
    InputError
        For an argument that is neither a switch nor a function.
    """
    if callable(progress):
        yield progress
    elif progress is None or not switch_of(
        "progress", progress, "a function of parts done and parts in all"
    ):
        yield None
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield Bar(doing)
            return
        with tqdm(desc=doing, total=None) as bar:

            def show(done: int, of: int) -> None:
                if bar.total != of and of > 0:
                    bar.reset(total=of)
                bar.update(done - bar.n)

            yield show


class Bar:
    """A line on standard error, written at most five times a second."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._began = time.monotonic()
        self._next = 0.0

    def __call__(self, done: int, total: int) -> None:
        now = time.monotonic() - self._began
        # total is 0 if the parts cannot be counted: the end is then unknown
        is_done = 0 < total <= done
        if now < self._next and not is_done:
            return
        self._next = now + 0.2
        left = f", {now * (total - done) / done:.0f} s left" if 0 < done < total else ""
        end = "\n" if is_done else ""
        counted = f"{done:,} of {total:,}" if total > 0 else f"{now:.0f} s"
        sys.stderr.write(f"\r{self._what}: {counted}{left}   {end}")
        sys.stderr.flush()
