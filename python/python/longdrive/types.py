"""Types that several modules name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._longdrive import Setup

__all__ = ["Floats", "Names", "Sense", "SetupLike"]

Floats = npt.NDArray[np.float64]
"""An array of numbers in SI."""

Names = Union[str, Sequence[str]]
"""A name or several."""

Sense = Literal["max", "min"]
"""Whether the greatest value is looked for or the least."""

SetupLike = Union["Setup", str, Mapping[str, Any], None]
"""A setup, the name of a preset, a dict as :class:`longdrive.Setup` takes it, or None for the preset ``tour-average``."""
