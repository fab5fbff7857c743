"""Progress of long work, in notebooks and terminals."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

__all__ = ["Progress", "follower"]

Show = Callable[[int, int], Any]

Progress = Union[bool, Show]
"""Whether a bar is shown (by tqdm, if it is installed, in notebooks too), or a function that is called with how many parts of how many are
done (0 of 0 where they cannot be counted)."""


@contextmanager
def follower(doing: str, progress: Progress) -> Iterator[Show | None]:
    """What is to be called with the progress of some work; None where nobody looks."""
    if progress is False:
        yield None
    elif progress is not True:
        yield progress
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield _line(doing)
            print(file=sys.stderr)
            return
        with tqdm(desc=doing, total=None) as bar:

            def show(done: int, of: int) -> None:
                if bar.total != of and of > 0:
                    bar.reset(total=of)
                bar.update(done - bar.n)

            yield show


def _line(doing: str) -> Show:
    """Without tqdm: one line that is written over."""

    def show(done: int, of: int) -> None:
        share = f"{done} of {of}" if of else "…"
        print(f"\r{doing}: {share}", end="", file=sys.stderr, flush=True)

    return show
