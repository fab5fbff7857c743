"""Messages after Ctrl-C."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .reply import COMMON_KEYS

__all__ = ["interruption"]


def interruption(function: str, answer: Any, notes: Sequence[str], advice: str) -> str:
    """The message after Ctrl-C: the progress, the best result so far, and how to continue.

    Parameters
    ----------
    function : str
        The name of the function.
    answer : Any
        The answer of the command; without an answer, the list of the files that it wrote.
    notes : Sequence[str]
        The messages of the command so far.
    advice : str
        How to continue.
    """
    parts = [_progress(function, answer, notes)]
    if isinstance(answer, Mapping):
        parts += _best(answer)
    parts.append(advice)
    return "; ".join(part for part in parts if part)


def _progress(function: str, answer: Any, notes: Sequence[str]) -> str:
    if isinstance(answer, Mapping):
        reason = answer.get("message") or ""
        if answer["status"] != "interrupted":
            reason = f"it had just ended: {answer['status']}" + (f": {reason}" if reason else "")
        return f"{function} was interrupted" + (f": {reason}" if reason else "")
    last = f"; last message: {' '.join(notes[-1].split())}" if notes else ""
    written = f"; written before: {', '.join(answer)}" if answer else ""
    return f"{function} was interrupted before there was an answer{last}{written}"


def _best(answer: Mapping[str, Any]) -> list[str]:
    """The best result so far as text, rounded; the answer has all digits."""
    found = answer.get("optimum", answer)
    if found is None:
        return []
    if found is not answer and isinstance(found, Mapping) and found:
        goal = (
            f"{answer.get('objective')} = {_number(answer.get('value'))} at "
            if answer.get("value") is not None
            else ""
        )
        return [
            f"the best so far, in SI, is in `answer` of this exception: {goal}{_named(found)}"
        ]
    estimates = answer.get("estimates")
    if isinstance(estimates, Mapping) and estimates:
        values = {name: row["value"] for name, row in estimates.items()}
        return [
            f"the estimates so far, in SI, are in `answer` of this exception: {_named(values)}"
        ]
    points = answer.get("points")
    if isinstance(points, Sequence) and points:
        return [f"`answer` of this exception has the {len(points)} points so far"]
    has_result = answer.keys() - COMMON_KEYS
    return ["`answer` of this exception has the result so far"] if has_result else []


def _named(values: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {_number(value)}" for name, value in values.items())


def _number(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, (int, float)) else str(value)
