"""A hundred thousand drives with exact derivatives, and the effect of a degree of loft at each club
speed.

Run: python many_drives.py
"""

import numpy as np

import longdrive

draw = np.random.default_rng(1)
rows = 100_000
speed = draw.uniform(35, 55, rows)
table = longdrive.batch(
    "modern-driver", {"swing.speed": speed, "club.loft": np.radians(draw.uniform(7, 15, rows))}, of="carry", wrt="club.loft", progress=True
)
print(table)
per_degree = np.radians(1) * table.derivative("carry", "club.loft")
for low in range(35, 55, 5):
    rows_of_speed = (speed >= low) & (speed < low + 5)
    print(f"{low} to {low + 5} m/s: a degree more loft changes carry by {per_degree[rows_of_speed].mean():+.2f} m on average")
