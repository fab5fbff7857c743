"""The program: ``python -m longdrive``, or ``longdrive`` once the package is installed."""

from __future__ import annotations

import sys

from . import _longdrive


def main() -> int:
    """Runs the program with the arguments of this process; the exit status."""
    return _longdrive.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
