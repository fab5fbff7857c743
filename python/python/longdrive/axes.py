"""Plots in the axes of matplotlib, from the data of a plot."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError

if TYPE_CHECKING:
    from .types import Floats

__all__ = ["check_axes", "draw"]

_LOGARITHMIC = {"vcurve"}
"""Names of the plots with logarithmic axes. The data has no scales."""


def check_axes(ax: Any) -> None:
    """Checks the argument ``ax``.

    Raises
    ------
    InputError
        For an object without the methods of axes.
    """
    if not all(hasattr(ax, name) for name in ("plot", "fill_between", "set_xlabel")):
        raise InputError(
            f"ax = {ax!r}; expected axes of matplotlib, as in fig, ax = matplotlib.pyplot.subplots()"
        )


def draw(ax: Any, data: bytes, name: str, title: str) -> None:
    """Draws a plot into axes, in SI units and radians.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        The axes.
    data : bytes
        The data of the plot as CSV: a row for each point, with the kind and name of its layer.
    name : str
        The name of the plot, such as ``vcurve``.
    title : str
        The title, with the subtitle in a line of its own.

    Raises
    ------
    InputError
        For a plot of several fields, which has a panel for each, and for a plot of several lines
        without a name, which the data does not separate.
    """
    import csv
    import io

    heads, *rows = csv.reader(io.StringIO(data.decode("utf-8")))
    _refuse_undrawable(rows)
    layers: dict[tuple[str, str], list[list[str]]] = {}
    for row in rows:
        # for bars, the column `name` has the label of each bar instead of the name of the layer
        layer = "" if row[0] == "bar" else row[1]
        layers.setdefault((row[0], layer), []).append(row)
    if name in _LOGARITHMIC:
        ax.set_xscale("log")
        ax.set_yscale("log")
    for (kind, layer), members in layers.items():
        columns = {
            head: np.array([float(row[k] or "nan") for row in members])
            for k, head in enumerate(heads)
            if k >= 2
        }
        _draw_layer(ax, kind, layer, columns, [row[1] for row in members])
    places = [head for head in heads[2:] if not head.startswith("to ")]
    ax.set_xlabel(places[0])
    if len(places) > 1:
        ax.set_ylabel(places[1])
    ax.set_title(title)
    if any(layer for kind, layer in layers if kind in ("line", "dots", "mark", "band")):
        ax.legend()


def _refuse_undrawable(rows: list[list[str]]) -> None:
    """Refuses a plot whose layers the data does not separate."""
    runs = [head for head, _ in groupby((row[0], row[1]) for row in rows)]
    fields = [layer for kind, layer in runs if kind == "field"]
    if len(fields) > 1:
        fault = f"{len(fields)} panels ({'; '.join(fields)}), and axes hold one"
    elif runs.count(("line", "")) > 1:
        fault = "lines without names, which its data does not separate"
    else:
        return
    raise InputError(
        f"ax: this plot has {fault}; leave ax out, or give output='plot.svg', for the picture; "
        "output='plot.csv' for its data"
    )


def _draw_layer(
    ax: Any, kind: str, name: str, columns: dict[str, Floats], names: list[str]
) -> None:
    heads = [head for head in columns if not head.startswith("to ")]
    x = columns[heads[0]]
    y = columns[heads[1]] if len(heads) > 1 else x
    label = name or None
    if kind == "line":
        ax.plot(x, y, label=label)
    elif kind in ("dots", "mark"):
        ax.plot(x, y, "o", label=label)
    elif kind == "band":
        ax.fill_between(x, y, columns[f"to {heads[1]}"], alpha=0.3, label=label)
    elif kind == "bar":
        ax.barh(names, columns[f"to {heads[0]}"] - x, left=x)
    elif kind == "arrow":
        to_x, to_y = columns[f"to {heads[0]}"], columns[f"to {heads[1]}"]
        ax.quiver(x, y, to_x - x, to_y - y, angles="xy", scale_units="xy", scale=1)
    elif kind == "region":
        ax.plot(x, y, label=label)
    elif kind == "frame":
        to_x, to_y = columns[f"to {heads[0]}"], columns[f"to {heads[1]}"]
        for left, low, right, high in zip(x, y, to_x, to_y):
            ax.plot([left, right, right, left, left], [low, low, high, high, low], label=label)
    else:
        _draw_contours(ax, x, y, {head: columns[head] for head in heads[2:]})


def _draw_contours(ax: Any, x: Floats, y: Floats, fields: dict[str, Floats]) -> None:
    """Draws contours of the first field with finite values, labelled in the unit of its head.

    (x, y) are the nodes of a grid.
    """
    for head, field in fields.items():
        known = np.isfinite(field)
        if known.any():
            across, down = np.unique(x), np.unique(y)
            grid = np.full((len(down), len(across)), np.nan)
            grid[np.searchsorted(down, y), np.searchsorted(across, x)] = field
            lines = ax.contour(across, down, grid)
            ax.clabel(lines, fmt=_with_unit_of(head))
            return


def _with_unit_of(head: str) -> str:
    """The format of a number with the unit of a column head: ``%g m`` for ``carry [m]``."""
    _, _, unit = head.rstrip("]").partition("[")
    return f"%g {unit.replace('%', '%%')}".rstrip()
