"""Examples in the docstrings of the generated functions; the tests run them."""

from __future__ import annotations

__all__ = ["EXAMPLES"]

_SHOTS = """
>>> shots = {
...     "ball_speed [mph]": [165.0, 168.1, 162.0, 166.2],
...     "launch_angle [deg]": [11.2, 10.4, 11.5, 10.9],
...     "spin [rpm]": [2500.0, 2380.0, 2450.0, 2600.0],
...     "carry [yd]": [275.0, 281.0, 270.5, 277.0],
... }
"""

EXAMPLES = {
    "compare": """
>>> reply = longdrive.compare("tour-average", {"club.loft": "11 deg"}, of="carry")
>>> reply.status
'done'
""",
    "optimize": """
>>> best = longdrive.optimize("tour-average", vary={"club.loft": ("4 deg", "20 deg")})
>>> best.success, best.names
(True, ['club.loft'])
""",
    "optimum-sensitivity": """
>>> vary = {"club.loft": ("4 deg", "20 deg")}
>>> best = longdrive.optimum_sensitivity("mae494", vary=vary, wrt="swing.speed")
>>> best.success
True
""",
    "design": """
>>> club = {"preset": "modern-driver"}
>>> best = longdrive.design(
...     club, vary={"club.bulge_radius": ("250 mm", "400 mm")}, scenarios=8,
...     distribution={"strike.toe": ("normal", 0.0, 0.01)}, maximize="mean(carry)")
>>> best.names
['club.bulge_radius']
""",
    "calibrate": _SHOTS + """
>>> fit = longdrive.calibrate(shots, "modern-driver", fit="aero.cd0")
>>> list(fit.estimates)
['aero.cd0']
""",
    "delivery": """
>>> found = longdrive.delivery(ball_speed="150 mph", launch_angle="12 deg", spin="2600 rpm")
>>> found.status
'done'
""",
    "chart": """
>>> along = {"swing.speed": ("90 mph", "110 mph")}
>>> chart = longdrive.chart(along=along, vary={"club.loft": ("4 deg", "20 deg")})
>>> len(chart.points) > 2
True
""",
    "pareto": """
>>> front = longdrive.pareto(
...     "mae494", maximize="carry", minimize="spin", points=3,
...     vary={"club.loft": ("8 deg", "14 deg")})
>>> len(front.points) >= 3
True
""",
    "robust": """
>>> best = longdrive.robust(
...     model=["aero.law=smits-smith"], vary={"club.loft": ("4 deg", "20 deg")})
>>> best.names
['club.loft']
""",
    "report": """
>>> import tempfile
>>> with tempfile.TemporaryDirectory() as folder:
...     longdrive.report("mae494", output=folder).status
'done'
""",
    "fly": _SHOTS + """
>>> flown = longdrive.fly(shots)
>>> len(flown.shots)
4
""",
    "reproduce": """
>>> longdrive.reproduce("mae494").status  # doctest: +SKIP
'done'
""",
    "validate": """
>>> longdrive.validate().status  # doctest: +SKIP
'done'
""",
    "verify": """
>>> longdrive.verify("tour-average", of="carry", wrt="club.loft").status
'passed'
""",
    "sensitivity": """
>>> reply = longdrive.sensitivity("tour-average", of="carry")
>>> reply.outcomes[0]["of"]
'carry'
""",
    "uncertainty": """
>>> sigma = {"swing.speed": "1 mph"}
>>> reply = longdrive.uncertainty("tour-average", of="carry", sigma=sigma, samples=64)
>>> reply.status
'done'
""",
    "laws": """
>>> any(law["name"] == "smits-smith" for law in longdrive.laws().laws)
True
""",
    "plot trajectory": """
>>> longdrive.plot.trajectory("tour-average", width=640).form
'.svg'
""",
    "plot contour": """
>>> longdrive.plot.contour("mae494").title
'Carry over club loft and attack angle'
""",
    "plot chart": """
>>> along = {"swing.speed": ("90 mph", "100 mph")}
>>> longdrive.plot.chart("mae494", along=along).form
'.svg'
""",
    "plot pareto": """
>>> longdrive.plot.pareto("mae494", maximize="carry", minimize="spin", points=3).form
'.svg'
""",
    "plot tornado": """
>>> longdrive.plot.tornado("tour-average", of="carry").form
'.svg'
""",
    "plot compare": """
>>> longdrive.plot.compare("tour-average", other={"club.loft": "11 deg"}).form
'.svg'
""",
    "plot vcurve": """
>>> longdrive.plot.vcurve("tour-average", of="carry").form
'.svg'
""",
    "plot laws": """
>>> longdrive.plot.laws().form
'.svg'
""",
    "plot fairway": """
>>> longdrive.plot.fairway("tour-average", sigma={"swing.path": "1 deg"}).form
'.svg'
""",
    "plot face": """
>>> longdrive.plot.face("tour-average").form
'.svg'
""",
    "plot strike": """
>>> longdrive.plot.strike("tour-average").form
'.svg'
""",
    "plot launch": """
>>> longdrive.plot.launch("tour-average").form
'.svg'
""",
}
