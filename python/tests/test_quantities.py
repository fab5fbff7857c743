"""Quantities of pint: each is converted or refused; its number is never used without its unit."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError


def test_a_list_of_quantities_is_a_column_of_a_batch(unit: Any) -> None:
    wanted = longdrive.batch(
        "mae494", {"club.loft": np.radians([10.0, 11.0]), "swing.speed": [45.0, 50.0]}
    )
    for angles in (
        [10 * unit.deg, 11 * unit.deg],
        (10 * unit.deg, math.radians(11)),
        np.array([10 * unit.deg, 11 * unit.deg], dtype=object),
    ):
        table = longdrive.batch(
            "mae494",
            {
                "club.loft": angles,
                "swing.speed": [45 * unit("m/s"), 162 * unit("km/hour") + 5 * unit("m/s")],
            },
        )
        assert table["club.loft"] == pytest.approx(wanted["club.loft"], rel=1e-15)
        assert table["carry"] == pytest.approx(wanted["carry"], rel=1e-12)
    humid = longdrive.batch(
        {"air.temperature": "20 degC"}, {"air.humidity": [40 * unit.percent, 50 * unit.percent]}
    )
    assert humid["air.humidity"] == pytest.approx([0.4, 0.5], rel=1e-15)
    with pytest.raises(InputError, match="^points: club.loft: .*gram"):
        longdrive.batch("mae494", {"club.loft": [10 * unit.deg, 11 * unit.gram]})
    with pytest.raises(InputError, match="did you mean 'club.loft'"):
        longdrive.batch("mae494", {"club.lofft": [10 * unit.deg]})
    with pytest.raises(
        InputError,
        match=r"^shots: the column 'ball_speed \[mph\]' has quantities with units; the head of a column names the unit",
    ):
        longdrive.fly(
            {
                "ball_speed [mph]": [70 * unit.meter],
                "launch_angle [deg]": [11.0],
                "spin [rpm]": [2500.0],
            }
        )


def test_exact_difference_of_temperatures_in_kelvins(unit: Any) -> None:
    warm = longdrive.Setup({"air.temperature": "20 degC"})
    degrees = [unit.Quantity(2, name) for name in ("degC", "delta_degC", "kelvin")]

    def spread(**arguments: Any) -> Any:
        return longdrive.uncertainty(warm, samples=64, **arguments)

    for two in degrees:
        assert spread(sigma={"air.temperature": two}) == spread(sigma={"air.temperature": "2 degC"})
        normal = {"air.temperature": ("normal", unit.Quantity(20, "degC"), two)}
        assert spread(distribution=normal) == spread(
            distribution="air.temperature=normal(293.15 K,2 K)"
        )
        sensitivity = [
            longdrive.sensitivity(warm, sigma={"air.temperature": given})
            for given in (two, "2 degC")
        ]
        assert sensitivity[0] == sensitivity[1]
        changed = [
            longdrive.optimum_sensitivity(warm, change={"air.temperature": given}).reply["changes"]
            for given in (two, "+2 degC")
        ]
        assert changed[0] == changed[1]
    # the ends of a distribution are temperatures, its deviation is a difference of temperatures
    ends = [
        unit.Quantity(20, "degC"), degrees[0], unit.Quantity(15, "degC"), unit.Quantity(25, "degC")
    ]
    truncated = spread(distribution={"air.temperature": ("truncated", *ends)})
    assert truncated == spread(
        distribution="air.temperature=truncated(293.15 K,2 K,288.15 K,298.15 K)"
    )


def test_a_point_of_an_objective_may_have_quantities(unit: Any) -> None:
    carry = longdrive.objective("mae494", "carry", ["club.loft", "swing.speed"])
    plain, given = [math.radians(10), 50.0], [10 * unit.deg, 180 * unit("km/hour")]
    assert carry.fun(given) == pytest.approx(carry.fun(plain), rel=1e-12)
    assert carry.jac(tuple(given)) == pytest.approx(carry.jac(plain), rel=1e-9)
    assert carry.hess(np.array(given, dtype=object)) == pytest.approx(carry.hess(plain), rel=1e-6)
    loft = longdrive.objective("mae494", "carry", "club.loft")
    alone = loft.fun([math.radians(10)])
    for x in (10 * unit.deg, [10 * unit.deg], np.array([10.0]) * unit.deg):
        assert loft.fun(x) == pytest.approx(alone, rel=1e-12)
    with pytest.raises(InputError, match="^x: club.loft: .*meter"):
        carry.fun([10 * unit.meter, 50.0])
    with pytest.raises(InputError, match=r"^x has shape \(3,\); expected shape \(2,\)"):
        carry.fun([10 * unit.deg] * 3)


@pytest.mark.parametrize(
    "x",
    [
        ["0.2"],
        "0.2",
        True,
        np.array([True]),
        [True],
        [np.True_],
        [0.2 + 0j],
        np.array([0.2 + 1j]),
        [None],
        [b"0.2"],
    ],
)
def test_a_point_of_an_objective_has_only_numbers(x: Any) -> None:
    loft = longdrive.objective("mae494", "carry", "club.loft")
    for call in (loft.fun, loft.jac, loft.hess, loft.fun_and_jac):
        with pytest.raises(
            InputError,
            match="^x has (dtype|the truth value True as element 0).*; expected shape .*club.loft, SI$",
        ):
            call(x)


def test_a_boolean_among_numbers_is_refused() -> None:
    with pytest.raises(
        InputError, match="^points: club.loft has the truth value True as element 1; expected a number or"
    ):
        longdrive.batch("mae494", {"club.loft": [0.2, True]})
    with pytest.raises(InputError, match="^x has the truth value False as element 0; expected shape"):
        longdrive.objective("mae494", "carry", ["club.loft", "swing.speed"]).fun((False, 50.0))


def test_a_correlation_may_be_a_number_of_any_kind(unit: Any) -> None:
    spread = {"swing.path": ("normal", 0.0, 0.02), "swing.face_angle": ("normal", 0.0, 0.02)}
    pair = ("swing.path", "swing.face_angle")

    def mean(coefficient: Any) -> Any:
        return longdrive.objective(
            "mae494",
            "std(lateral)",
            "club.loft",
            distribution=spread,
            correlation={pair: coefficient},
        ).fun([0.2])

    assert {mean(given) for given in (np.float64(0.5), "0.5", 50 * unit.percent)} == {mean(0.5)}


ANGLES: list[Callable[[Any], Any]] = [
    lambda angle: longdrive.Setup({"impact.restitution": angle}),
    lambda angle: longdrive.batch("mae494", {"impact.restitution": angle}),
    lambda angle: longdrive.batch("mae494", {"impact.restitution": [angle]}),
    lambda angle: longdrive.optimize("mae494", vary={"impact.restitution": (angle, 0.9)}),
    lambda angle: longdrive.sensitivity("mae494", sigma={"impact.restitution": angle}),
    lambda angle: longdrive.objective("mae494", "carry", "impact.restitution").fun([angle]),
]


@pytest.mark.parametrize("call", ANGLES)
def test_an_angle_is_refused_as_a_plain_number(call: Callable[[Any], Any], unit: Any) -> None:
    with pytest.raises(
        InputError,
        match="impact.restitution: 20 degree is an angle; expected a number without a unit",
    ):
        call(20 * unit.deg)


def test_a_share_is_a_plain_number(unit: Any) -> None:
    assert longdrive.Setup({"impact.restitution": 80 * unit.percent})[
        "impact.restitution"
    ] == pytest.approx(0.8, rel=1e-15)
    with pytest.raises(InputError, match="unknown parameter 'club.lofft'"):
        longdrive.optimize("mae494", vary={"club.lofft": (4 * unit.deg, 20 * unit.deg)})
