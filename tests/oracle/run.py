#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Independent computation of the run of a ball on the ground: python3 run.py >
../data/independent_runs.json

Shares no code with the program. In each impact a rigid sphere meets a surface that its crater
tilts; two impulses act on it, one along the normal of this surface and one of friction. Hops are
parabolas; sliding and rolling are integrated in small time steps. The flight is in a vacuum and
lands at the height of the tee, so the landing is the mirror image of the launch.
"""
import json
import math

R, M, G = 0.021335, 0.04593, 9.80665
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
add = lambda a, b, k=1.0: [x + k * y for x, y in zip(a, b)]
mul = lambda a, k: [k * x for x in a]
cross = lambda a, b: [
    a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
]
norm = lambda a: math.sqrt(dot(a, a))


def held(x, end, over):
    """Smooth (C2) upper clamp of x. From `end` to `end + over` its slope decreases from 1 to 0 as
    (1 - t)^2 (1 + 2 t), which Simpson's rule integrates exactly, because it is a cubic."""
    if x <= end:
        return x
    t = min(1.0, (x - end) / over)
    slope = lambda t: (1 - t) ** 2 * (1 + 2 * t)
    return end + over * t / 6 * (slope(0) + 4 * slope(t / 2) + slope(t))


def step(x, start, over):
    t = min(1.0, max(0.0, (x - start) / over))
    return t ** 3 * (6 * t * t - 15 * t + 10)


def impact(v, w, n, turf, inertia):
    down = -dot(v, n)
    level = add(v, n, down)
    phi = math.degrees(math.atan2(norm(level), down))
    theta = phi * held(turf["compliance"] / 44.4 * norm(v) / 18.6, 0.7, 0.6) * step(90 - phi, 0, 70)
    s, c = math.sin(math.radians(theta)), math.cos(math.radians(theta))
    normal = add(mul(n, c), level, -s / norm(level)) if norm(level) > 0 else n
    u = -dot(v, normal)
    held_u = held(u, 18.0, 2 * (0.0375 / (2 * 0.000903) - 18.0))
    e = turf["restitution"] / 0.51 * (0.510 - 0.0375 * held_u + 0.000903 * held_u ** 2)
    arm = mul(normal, -R)
    slip = add(add(v, normal, u), cross(w, arm))
    # impulses per mass: along the normal, and the impulse of friction that stops the slip
    push = (1 + e) * u
    stick = norm(slip) / (1 + M * R * R / inertia)
    most = turf["friction"] * push
    rub = most * held(stick / most, 0.8, 0.4)
    impulse = mul(slip, -rub / norm(slip)) if norm(slip) > 0 else [0, 0, 0]
    v = add(add(v, normal, push), impulse)
    return v, add(w, cross(arm, impulse), M / inertia)


def run(v, w, turf, inertia):
    """Position of the ball at rest, m, from its landing (up, right, downrange); and the number of
    bounces."""
    n = [1.0, -math.tan(math.radians(turf["side_slope"])), -math.tan(math.radians(turf["slope"]))]
    n = mul(n, 1 / norm(n))
    way, bounces = [0.0, 0.0, 0.0], 0
    while True:
        v, w = impact(v, w, n, turf, inertia)
        bounces += 1
        rise = dot(v, n)
        left = rise * step(rise, 0.2, 0.2)
        v = add(v, n, left - rise)
        if left <= 0:
            break
        # back on the plane: n·(v t − g t²/2 x) = 0
        t = 2 * left / (G * n[0])
        way = add(add(way, v, t), [1, 0, 0], -0.5 * G * t * t)
        v = add(v, [1, 0, 0], -G * t)
    press, along = G * n[0], add([-G, 0, 0], n, G * n[0])
    h, arm = 1e-5, mul(n, -R)

    def rates(v, w):
        slip = add(v, cross(w, arm))
        rub = mul(slip, -turf["friction"] * press / max(norm(slip), 1e-9))
        return add(along, rub), mul(cross(arm, rub), M / inertia)

    slip = lambda: add(v, cross(w, arm))
    while norm(slip()) > 2e-4:
        dv, dw = rates(v, w)
        dv, dw = rates(add(v, dv, h / 2), add(w, dw, h / 2))
        way = add(add(way, v, h), dv, h * h / 2)
        v, w = add(v, dv, h), add(w, dw, h)
    share = 1 / (1 + inertia / (M * R * R))
    brake = turf["rolling"] * press
    while norm(v) > 5e-5:
        half = add(v, add(mul(along, share), v, -brake / norm(v)), h / 2)
        way = add(way, half, h)
        v = add(v, add(mul(along, share), half, -brake / norm(half)), h)
    return way, bounces


def ball(speed, angle, direction, back, side):
    """State of a ball that lands after a flight in a vacuum: the mirror image of its launch."""
    a, d = math.radians(angle), math.radians(direction)
    v = [-speed * math.sin(a), speed * math.cos(a) * math.sin(d), speed * math.cos(a) * math.cos(d)]
    up = [math.sin(a), math.cos(a) * math.sin(d), math.cos(a) * math.cos(d)]
    w = mul([0, math.cos(d), -math.sin(d)], back)
    return v, add(w, [-math.cos(a), up[0] * math.sin(d), up[0] * math.cos(d)], side)


AVERAGE = {
    "restitution": 0.51,
    "friction": 0.4,
    "compliance": 15.4,
    "rolling": 1.0,
    "slope": 0.0,
    "side_slope": 0.0,
}
CASES = [
    ("a drive", (30, 38, 0, 220, 0), {}, None),
    ("a drive that curves", (30, 38, -4, 210, 60), {}, None),
    ("low and fast", (38, 14, 2, 150, -40), {}, None),
    ("a skimming ball", (40, 5, 0, 100, 0), {}, None),
    ("a wedge", (26, 50, 0, 800, 100), {}, None),
    ("straight down, nearly", (20, 85, 0, 0, 0), {}, None),
    ("so fast that the crater would face away", (60, 45, 0, 200, 0), {}, None),
    ("slow", (6, 30, 0, 50, 0), {}, None),
    ("little friction: it slides", (28, 35, 3, 300, 0), {"friction": 0.05, "rolling": 0.1}, None),
    (
        "stiff ground",
        (30, 38, 0, 220, 0),
        {"compliance": 0.0, "restitution": 0.7, "rolling": 0.1},
        None,
    ),
    ("uphill", (30, 38, 0, 220, 0), {"slope": 5.0}, None),
    (
        "downhill and sideways",
        (30, 38, 1, 220, -50),
        {"slope": -4.0, "side_slope": 6.0, "rolling": 0.3},
        None,
    ),
    ("a hollow ball", (30, 38, 0, 220, 20), {}, 8.336e-6),
]

if __name__ == "__main__":
    drives = []
    for name, launch, changes, inertia in CASES:
        turf = {**AVERAGE, **changes}
        way, bounces = run(*ball(*launch), turf, inertia or 0.4 * M * R * R)
        names = ["ball_speed", "launch_angle", "launch_direction", "backspin", "sidespin"]
        drives.append(
            {
                "name": name,
                "launch": dict(zip(names, launch)),
                "ground": turf,
                "inertia": inertia,
                "run": way[2],
                "right": way[1],
                "bounces": bounces,
            }
        )
    print(json.dumps({"drives": drives}, indent=1, ensure_ascii=False))
