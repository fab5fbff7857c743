"""Refuses an interpreter that the compiled module does not support."""

from __future__ import annotations

import sys

# the module uses the stable interface (abi3), which free-threaded builds of Python do not have
if "free-threading build" in sys.version:
    raise ImportError(
        "longdrive needs Python with the global interpreter lock, and this is a free-threaded "
        f"build ({sys.version.split(' (')[0]}): use the ordinary build of Python 3.10 or later"
    )
