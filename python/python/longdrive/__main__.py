"""The program: ``python -m longdrive``, or ``longdrive`` after the installation."""

from __future__ import annotations

import sys

from . import _longdrive


def main() -> int:
    """Runs the program with the arguments of this process, and returns its exit status."""
    return _longdrive.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
