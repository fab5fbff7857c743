"""How far long work has come, as a line on standard error: in a terminal and in a notebook."""

from __future__ import annotations

import sys
import time

__all__ = ["Bar"]


class Bar:
    """Writes one line and replaces it, at most five times a second."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._began = time.monotonic()
        self._next = 0.0

    def __call__(self, done: int, total: int) -> None:
        now = time.monotonic() - self._began
        if now < self._next and done < total:
            return
        self._next = now + 0.2
        left = f", {now * (total - done) / done:.0f} s left" if 0 < done < total else ""
        end = "\n" if done >= total else ""
        sys.stderr.write(f"\r{done:,} of {total:,} {self._what}{left}   {end}")
        sys.stderr.flush()
