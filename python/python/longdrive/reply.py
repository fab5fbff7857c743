"""The answers of the commands."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from html import escape
from typing import TYPE_CHECKING, Any, TypeVar

__all__ = ["Reply", "as_reply"]


class Reply(dict[str, Any]):
    """The answer of a command: the content of its ``--json``, with attributes for the keys.

    Numbers are SI; None is a missing value. ``docs/json.md`` describes the keys of each command.
    """

    command: str
    """The name of the command."""
    status: Any
    """The end of the work in one word, such as ``done`` or ``converged``."""
    message: Any
    """The same in a sentence; None if there is nothing to say."""
    warnings: list[str]
    """Warnings about the question or the answer."""

    if not TYPE_CHECKING:  # type checkers know the attributes of each answer

        def __getattr__(self, name: str) -> Any:
            try:
                return self[name]
            except KeyError:
                kind, keys = type(self).__name__, ", ".join(self)
                raise AttributeError(f"this {kind} has no {name!r}; it has {keys}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        def shown(value: Any) -> str:
            if isinstance(value, Mapping) and value:
                return f"{{{len(value)} keys}}"
            if isinstance(value, list) and value:
                return f"[{len(value)} items]"
            return repr(value)

        lines = "".join(f"\n  {key}: {shown(value)}" for key, value in self.items())
        return f"<{type(self).__name__}{lines}>"

    def _repr_html_(self) -> str:
        rows = "".join(_row(key, value) for key, value in self.items())
        return f"<table><tbody>{rows}</tbody></table>"


R = TypeVar("R", bound=Reply)


def as_reply(kind: type[R]) -> Callable[[Reply, object], R]:
    """The function that makes an answer of this class."""
    return lambda reply, _request: kind(reply)


def _row(key: str, value: Any) -> str:
    style = "style='text-align:left'"
    return f"<tr><th {style}>{escape(key)}</th><td {style}>{_cell(value)}</td></tr>"


def _cell(value: Any) -> str:
    if isinstance(value, Mapping):
        inner = "".join(_row(str(key), part) for key, part in value.items())
        if not value:
            return ""
        return (
            f"<details><summary>{len(value)}</summary><table><tbody>{inner}</tbody></table>"
            "</details>"
        )
    if isinstance(value, list):
        if value and isinstance(value[0], Mapping):
            return f"<details><summary>{len(value)}</summary>{_listed(value)}</details>"
        return (
            escape(", ".join(_text(part) for part in value[:12]))
            + (", …" if len(value) > 12 else "")
        )
    return escape(_text(value))


def _listed(rows: list[Any]) -> str:
    heads = list(rows[0])
    head = "".join(f"<th>{escape(str(key))}</th>" for key in heads)
    body = "".join(
        f"<tr>{''.join(f'<td>{_cell(row.get(key))}</td>' for key in heads)}</tr>"
        for row in rows
        if isinstance(row, Mapping)
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _text(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else str(value)
