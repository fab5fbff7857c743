"""What is said where Ctrl-C has ended the work of a command."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

__all__ = ["interruption"]


def interruption(function: str, answer: Any, notes: Sequence[str], goes_on: str) -> str:
    """How far it was, the best so far, and how to go on.

    `answer` is the program's, or a list of the files that it had written where it was left before it could answer; `notes` are what it told on
    its way.
    """
    parts = [_how_far(function, answer, notes)]
    if isinstance(answer, Mapping):
        parts += _best(answer)
    parts.append(goes_on)
    return "; ".join(part for part in parts if part)


def _how_far(function: str, answer: Any, notes: Sequence[str]) -> str:
    if isinstance(answer, Mapping):
        why = answer.get("message") or ""
        if answer["status"] != "interrupted":
            why = f"it had just ended: {answer['status']}" + (f": {why}" if why else "")
        return f"{function} was interrupted" + (f": {why}" if why else "")
    told = f"; it told last: {' '.join(notes[-1].split())}" if notes else ""
    written = f"; written before: {', '.join(answer)}" if answer else ""
    return f"{function} was interrupted before there was an answer{told}{written}"


def _best(answer: Mapping[str, Any]) -> list[str]:
    """The best so far, in words; the answer itself has every digit."""
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
            f"the best so far, in SI, which `answer` of this exception has: {goal}{_named(found)}"
        ]
    estimates = answer.get("estimates")
    if isinstance(estimates, Mapping) and estimates:
        values = {name: row["value"] for name, row in estimates.items()}
        return [f"so far, in SI, which `answer` of this exception has: {_named(values)}"]
    points = answer.get("points")
    if isinstance(points, Sequence) and points:
        return [f"`answer` of this exception has the {len(points)} points so far"]
    return (
        ["`answer` of this exception has what was found"]
        if answer.keys() - {"command", "status", "message", "warnings"}
        else []
    )


def _named(values: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {_number(value)}" for name, value in values.items())


def _number(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, (int, float)) else str(value)
