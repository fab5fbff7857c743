"""Answers, drives and tables as HTML, for notebooks."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _longdrive
from .table import Status

if TYPE_CHECKING:
    from .drive import Drive
    from .reply import Reply
    from .table import Table

__all__ = ["html_of_drive", "html_of_reply", "html_of_table"]

_SHOWN_ROWS = 10


def html_of_drive(drive: Drive) -> str:
    """The outcomes of a drive with their units."""

    def row(name: str, value: float | None) -> str:
        shown = "" if value is None else f"{value:.6g} {_longdrive.unit_of(name) or ''}"
        return f"<tr><td>{escape(name.replace('_', ' '))}</td><td>{escape(shown)}</td></tr>"

    rows = "".join(row(name, value) for name, value in drive.outcomes.items())
    caption = escape(drive.message or drive.status)
    return f"<table><caption>drive: {caption}</caption><tbody>{rows}</tbody></table>"


def html_of_table(table: Table) -> str:
    """The first rows of a table."""
    names = table.keys()
    head = "".join(f"<th>{escape(name)}</th>" for name in names)

    def cell(name: str, row: int) -> str:
        if name == "status":
            return Status(table.status[row]).label
        number = table[name][row]
        return "" if np.isnan(number) else f"{number:.6g}"

    def line(row: int) -> str:
        return "<tr>" + "".join(f"<td>{escape(cell(name, row))}</td>" for name in names) + "</tr>"

    rows = "".join(line(row) for row in range(min(_SHOWN_ROWS, len(table))))
    caption = escape(repr(table).strip("<>"))
    return (
        f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead>"
        f"<tbody>{rows}</tbody></table>"
    )


def html_of_reply(reply: Reply) -> str:
    """The keys of an answer; dicts and lists of dicts are tables that unfold."""
    rows = "".join(_row(key, value) for key, value in reply.items())
    return f"<table><tbody>{rows}</tbody></table>"


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
