"""The longest drive by SciPy: with exact gradient and Hessian, within the range of a golfer's
swings.

Needs SciPy. Run: python scipy_optimum.py
"""

import numpy as np
from scipy.optimize import minimize

import longdrive

NAMES = ["club.loft", "swing.attack_angle"]
BOUNDS = np.radians([[4, 20], [-5, 5]])

carry = longdrive.objective("tour-average", "carry", NAMES, "max", invalid="nan")
found = minimize(
    carry.fun, carry.x0, jac=carry.jac, hess=carry.hess, bounds=BOUNDS, method="trust-constr", options={"gtol": 1e-9, "xtol": 1e-12}
)
loft, attack = np.degrees(found.x)
print(f"loft {loft:.2f} deg, attack angle {attack:.2f} deg: carry {-found.fun:.2f} m ({found.nit} iterations)")
