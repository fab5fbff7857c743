"""Types of arguments."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, Union

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._longdrive import Setup

__all__ = [
    "Amount",
    "AngleUnit",
    "Floats",
    "Given",
    "Goals",
    "Names",
    "PathLike",
    "PointsLike",
    "Sense",
    "SetupLike",
    "TableLike",
]

Floats: TypeAlias = "npt.NDArray[np.float64]"
"""An array of numbers in SI."""

Names = Union[str, Sequence[str], "npt.NDArray[np.str_]"]
"""A name or several."""

Sense = Literal["max", "min"]
"""The direction of a search: the largest or the smallest value."""

AngleUnit = Literal["rad", "deg"]
"""The unit of angles that are given as numbers."""

SetupLike = Union["Setup", str, Mapping[str, Any], None]
"""A setup, the name of a preset, a dict for :class:`longdrive.Setup`, or None for the preset
``tour-average``."""

Amount = Union[str, float]
"""A quantity: a text with its unit, or a number in SI."""

Given = Union[str, Iterable[Any], Mapping[Any, Any]]
"""Names with values: a dict like ``{"club.loft": ("4 deg", "20 deg")}``, whose numbers are SI, or
texts as on the command line, ``["club.loft=4deg..20deg"]``."""

Goals = Union[str, Iterable[str]]
"""A goal or several, such as ``"mean(carry)"``."""

PathLike = Union[str, "os.PathLike[str]"]
"""A file or a folder."""

PointsLike = Union[Mapping[str, "npt.ArrayLike"], Any]
"""Parameters with arrays, or a table of pandas, polars or pyarrow, whose columns are in SI."""

TableLike = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]
"""A file, a dict of columns, or a table of pandas, polars or pyarrow. The head of a column names
its unit: ``"carry [yd]"``."""
