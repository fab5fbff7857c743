"""Types that several modules name."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Union


import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._longdrive import Setup

__all__ = [
    "Amount", "Floats", "Given", "Goals", "Names", "PathLike", "Sense", "SetupLike", "TableLike"
]

Floats = npt.NDArray[np.float64]
"""An array of numbers in SI."""

Names = Union[str, Sequence[str]]
"""A name or several."""

Sense = Literal["max", "min"]
"""Whether the greatest value is looked for or the least."""

SetupLike = Union["Setup", str, Mapping[str, Any], None]
"""A setup, the name of a preset, a dict as :class:`longdrive.Setup` takes it, or None for the preset ``tour-average``."""

Amount = Union[str, float]
"""A quantity: a text with its unit, or a number in SI."""

Given = Union[str, Iterable[Any], Mapping[Any, Any]]
"""Names with values: a dict like ``{"club.loft": ("4 deg", "20 deg")}``, whose numbers are SI, or texts as the program has them, ``["club.loft=4deg..20deg"]``."""

Goals = Union[str, Iterable[str]]
"""A goal or several, like ``"mean(carry)"``."""

PathLike = Union[str, "os.PathLike[str]"]
"""A file or a folder."""

TableLike = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]
"""A file, a dict of columns, or a table of pandas, polars or pyarrow. A head names its unit, as in ``"carry [yd]"``."""
