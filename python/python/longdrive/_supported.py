"""Refuses an interpreter that the compiled module was not made for."""

from __future__ import annotations

import sys

# the module is compiled for the stable interface (abi3), which free-threaded builds of Python do not have
if "free-threading build" in sys.version:
    raise ImportError(
        f"longdrive needs Python with the global interpreter lock, and this is a free-threaded build ({sys.version.split(' (')[0]}): " "use the ordinary build of Python 3.10 or later"
    )
