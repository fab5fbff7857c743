"""Setups: construction, immutability, and messages about wrong ones."""

from __future__ import annotations

import copy
import math
import pickle
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Setup


def test_same_setup_from_texts_and_numbers() -> None:
    nested = Setup(
        {"preset": "tour-average", "club": {"loft": "10.5 deg", "inertia": {"xx": "5679 g cm^2"}}}
    )
    dotted = Setup(
        {
            "preset": "tour-average",
            "club.loft": math.radians(10.5),
            "club.inertia.xx": np.float64(5.679e-4),
        }
    )
    assert nested == dotted and hash(nested) == hash(dotted)
    assert nested["club.loft"] == math.radians(10.5)
    assert nested != Setup() and Setup() == Setup("tour-average") == Setup(None)


def test_a_dict_without_a_preset_starts_from_that_of_a_setup_file() -> None:
    assert Setup({}) == Setup("tour-average") == Setup.from_toml("")


def test_exact_conversion_of_quantities_of_pint(unit: Any) -> None:
    setup = Setup(
        {
            "swing.speed": 110 * unit.mph,
            "club.inertia.xx": 5679 * unit("g * cm**2"),
            "club.mass": 0.2 * unit.kg,
            "air.temperature": unit.Quantity(20, "degC"),
            "impact.restitution": 0.8 * unit.dimensionless,
        }
    )
    assert setup["swing.speed"] == pytest.approx(110 * 0.44704, rel=1e-15)
    assert setup["club.inertia.xx"] == pytest.approx(5.679e-4, rel=1e-15)
    assert setup["air.temperature"] == pytest.approx(293.15, rel=1e-15)
    with pytest.raises(InputError, match="club.loft: Cannot convert"):
        Setup({"club.loft": 10 * unit.kg})


# a value in SI, and the unit symbols that each parameter accepts
STATED: list[tuple[str, float, str, list[str]]] = [
    ("club.bulge_radius", 0.3, "m", ["m", "um", "mm", "cm", "km", "in", "ft", "yd", "mi"]),
    ("club.mass", 0.2, "kg", ["kg", "g", "mg", "oz", "lb"]),
    ("swing.speed", 50.0, "m/s", ["m/s", "m/ms", "m/min", "m/h", "mph", "kph", "kn"]),
    ("club.loft", 0.2, "rad", ["rad", "mrad", "deg", "rev"]),
    ("swing.closure.x", 20.0, "rad/s", ["rpm"]),
    ("impact.restitution", 0.8, "", ["1", "%"]),
    ("air.pressure", 1e5, "Pa", ["Pa", "hPa", "kPa", "bar", "mbar", "mmHg", "inHg", "psi", "N/m^2"]),
    ("air.density", 1.2, "kg/m^3", ["g/L"]),
    ("air.viscosity", 1.8e-5, "Pa s", ["P", "cP"]),
    ("air.temperature", 290.0, "K", ["K", "degC", "degF"]),
]


@pytest.mark.parametrize(("parameter", "value", "si", "symbols"), STATED)
def test_independent_sizes_of_units_are_those_of_pint(
    parameter: str, value: float, si: str, symbols: list[str], unit: Any
) -> None:
    quantity = unit.Quantity(value, si)
    for symbol in symbols:
        number = quantity.to({"1": "", "rev": "turn"}.get(symbol, symbol)).magnitude
        assert Setup({parameter: f"{number!r} {symbol}"})[parameter] == pytest.approx(
            value, rel=4 * np.finfo(float).eps
        ), symbol

def random_setup(seed: int) -> Setup:
    """A random setup, whose numbers have all digits of a float."""
    draw = random.Random(seed)
    preset = draw.choice([row["name"] for row in longdrive.presets()["presets"]])
    setup = Setup(preset)
    changes: dict[str, Any] = {}
    for name, value in setup.to_dict().items():
        if isinstance(value, float) and math.isfinite(value) and value != 0 and not name.startswith(
            "flight."
        ):
            changes[name] = value * (1 + 1e-3 * draw.random())
    return setup.replace(changes)


@pytest.mark.parametrize("seed", range(40))
def test_same_bits_after_every_round_trip(seed: int, tmp_path: Path) -> None:
    setup = random_setup(seed)
    file = tmp_path / "setup.toml"
    file.write_text(setup.to_toml())
    same = [
        pickle.loads(pickle.dumps(setup)),
        copy.copy(setup),
        copy.deepcopy(setup),
        Setup.from_toml(setup.to_toml()),
        Setup.read(file),
        Setup.read(str(file)),
        Setup(setup.to_dict()),
    ]
    for other in same:
        assert other == setup and hash(other) == hash(setup)
        assert other.to_dict() == setup.to_dict()
        assert repr(other) == repr(setup)
    carry = longdrive.simulate(setup)["carry"]
    assert carry is not None and all(longdrive.simulate(other)["carry"] == carry for other in same)


def test_negative_zero_survives_a_file() -> None:
    setup = Setup({"swing.attack_angle": -0.0})
    assert math.copysign(1, Setup.from_toml(setup.to_toml())["swing.attack_angle"]) == -1
    assert (
        setup == Setup({"swing.attack_angle": 0.0})
        and hash(setup) == hash(Setup({"swing.attack_angle": 0.0}))
    )


def test_a_setup_cannot_be_changed_and_replace_makes_another() -> None:
    setup = Setup()
    other = setup.replace({"club.loft": "11 deg"}, **{"swing.speed": 50}, strike={"toe": "5 mm"})
    assert (other["club.loft"], other["swing.speed"], other["strike.toe"]) == (
        math.radians(11), 50.0, 0.005
    )
    assert setup == Setup()
    with pytest.raises(AttributeError):
        setup.preset = "mae494"  # type: ignore[misc]


def test_iteration_over_a_setup_gives_its_names() -> None:
    setup = longdrive.Setup("modern-driver")
    assert list(setup) == list(setup.keys()) == list(dict(setup)) and len(setup) == len(dict(setup)) > 40
    assert {name: setup[name] for name in setup} == dict(setup)


def in_force(setup: Setup, name: str) -> Any:
    return next(
        row["value"]
        for row in longdrive.parameters(setup)["parameters"]
        if row["parameter"] == name
    )


@pytest.mark.parametrize(
    ("given", "follows"),
    [
        ({"air.temperature": "35 degC", "air.altitude": "1 mi"}, ["air.density", "air.viscosity"]),
        ({"wind.speed": "10 mph", "wind.from": "60 deg"}, ["wind.right", "wind.downrange"]),
    ],
)
def test_same_dependent_values_in_setup_and_drive(
    given: dict[str, Any], follows: list[str]
) -> None:
    setup, without = Setup({"preset": "mae494", **given}), Setup("mae494")
    for name in follows:
        assert setup[name] == in_force(setup, name) != without[name] and name in setup
        # the keys are the parameters that make the setup, without values that follow from others
        assert (
            name not in setup.keys()
            and name in without.keys()
            and without[name] == in_force(without, name)
        )
    assert Setup(dict(setup)) == setup == Setup(setup.to_dict())


def test_infinite_and_unset_values_and_choices() -> None:
    setup = Setup(
        {
            "club.bulge_radius": math.inf,
            "impact.friction": None,
            "aero.law": "ferguson",
            "golfer": "left",
        }
    )
    assert (setup["club.bulge_radius"], setup["impact.friction"]) == (math.inf, None)
    assert (setup["aero.law"], setup["golfer"], setup["aero.table"]) == ("ferguson", "left", None)
    assert Setup(setup.to_dict()) == setup
    assert "club.loft" in setup and "aero.law" in setup and "club.lofft" not in setup


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"club.lofft": 0.2}, r"unknown parameter 'club.lofft'; did you mean 'club.loft'\?"),
        ({"club.loft": 10}, r'club.loft = 572.9578 deg .10 rad. .*did you mean "10 deg"\?'),
        ({"club.loft": "10"}, r'club.loft: "10" has no unit'),
        ({"club.loft": "10 kg"}, r'club.loft: "10 kg" is not an angle'),
        ({"club.loft": math.nan}, "club.loft"),
        ({"club.loft": True}, "'club.loft' is a bool; expected a number"),
        ({"club.loft": [0.2]}, "'club.loft' is a list; expected a number"),
        ({"club.loft": None}, "club.loft"),
        ({"club": {"loft": 0.2}, "club.loft": 0.2}, "'club.loft' is given twice; keep one"),
        ({3: 0.2}, "the key 3 of a setup is no text"),
        ({"preset": "mae"}, r"unknown preset 'mae'; did you mean 'mae494'\?"),
        ({"preset": 3}, "'preset' is 3; expected the name"),
        ({"aero.cd0": 0.3, "aero.law": "linear"}, "'aero.cd0' is a coefficient of robinson"),
        (
            {"air.density": 1.2, "air.temperature": "20 degC"},
            "air.density and air.temperature are both given",
        ),
        ({"club.inertia.xx": 1e-9}, "club.inertia"),
        ({"clubs": {}}, "unknown parameter 'clubs'"),
        ({"foo.bar": {}}, "unknown parameter 'foo.bar'"),
        ({"club": {"lofft": {}}}, r"unknown parameter 'club.lofft'; did you mean 'club.loft'\?"),
        ({"club.loft": {}}, "'club.loft' is a dict; expected a number"),
        ({"aero.law": {}}, "'aero.law' is a dict"),
        ({"preset": {}}, "'preset' is {}; expected the name"),
        ({"clubs": [1]}, "unknown parameter 'clubs'"),
        ("mine", "unknown preset 'mine'"),
        (3.0, "a setup cannot be made of a float"),
    ],
)
def test_bad_input_is_a_value_error_with_the_message_of_the_program(
    given: Any, message: str
) -> None:
    with pytest.raises(InputError, match=message) as caught:
        Setup(given)
    assert isinstance(caught.value, ValueError)


def test_an_empty_group_changes_nothing() -> None:
    assert Setup(
        {"preset": "mae494", "club": {"inertia": {}}, "air": {}, "club.weight_1": {}, "aero": {}}
    ) == Setup("mae494")


def test_a_stated_value_is_never_replaced_without_a_message() -> None:
    dense = Setup({"air.density": 1.1})
    with pytest.raises(InputError, match="air.density and air.temperature are both given"):
        dense.replace({"air.temperature": "20 degC"})
    # follow the advice of the message
    warm = dense.replace({"air.density": "none", "air.temperature": "20 degC"})
    assert longdrive.simulate(warm)["carry"] == longdrive.simulate(
        Setup({"air.temperature": "20 degC"})
    )["carry"]


def test_the_message_on_a_wrong_file_has_line_and_column(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text("[club]\nloft = '10 kg'\n")
    with pytest.raises(InputError, match=r"mine.toml:2:8: club.loft"):
        Setup.read(file)
    with pytest.raises(InputError, match="nothing.toml"):
        Setup.read(tmp_path / "nothing.toml")


def test_short_and_long_descriptions() -> None:
    setup = Setup().replace({"club.loft": "10.5 deg"})
    assert repr(setup) == "<longdrive.Setup tour-average with club loft 10.5°>"
    assert "<td>club loft</td><td>10.5°</td><td>8.8°</td>" in setup._repr_html_()
    assert repr(Setup()) == "<longdrive.Setup tour-average>"
    assert any(
        "not used" in text
        for text in Setup(
            {
                "club.loft": "12 deg",
                "launch": {
                    "ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": "2600 rpm"
                },
            }
        ).warnings()
    )


def test_a_users_table_pickles_by_its_file_and_a_changed_file_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "mine.csv"
    head, rows = "spin_ratio,cd,cl", [
        (0.0, 0.22, 0.0), (0.1, 0.24, 0.14), (0.2, 0.27, 0.21), (0.3, 0.31, 0.26)
    ]
    file.write_text("\n".join([head, *(",".join(map(str, row)) for row in rows)]))
    setup = Setup({"aero.table": str(file)})
    assert (setup["aero.law"], Path(setup["aero.table"])) == ("table", file)
    pickled = pickle.dumps(setup)
    assert pickle.loads(pickled) == setup == Setup(setup.to_dict())
    file.write_text(file.read_text().replace("0.22", "0.23"))
    with pytest.raises(InputError, match="mine.csv' is not what it was when the setup was pickled"):
        pickle.loads(pickled)


@pytest.mark.parametrize("seed", range(10))
def test_a_setup_without_a_step_lets_the_command_choose(seed: int) -> None:
    setup = random_setup(seed).replace({"swing.speed": 47.0 + seed})
    text, is_text = setup._for_command()
    keys = {line.split(" = ")[0] for line in text.splitlines() if " = " in line}
    chosen = setup.replace({"flight.step": setup["flight.step"]})
    assert is_text and Setup.from_toml(chosen._for_command()[0]) == chosen
    if "method" not in keys:
        # a reader of the text uses method and step of the preset
        assert "step" not in keys and Setup.from_toml(text) == setup
    assert {"method", "step"} <= {line.split(" = ")[0] for line in chosen._for_command()[0].splitlines()}


def _setups(values: dict[str, str], folder: Path) -> list[Any]:
    """The same stated values as a dict, a setup, a pickled setup and a file."""
    groups = {name.split(".")[0] for name in values}
    lines = []
    for group in groups:
        lines.append(f"[{group}]")
        lines += [
            f'{name.split(".", 1)[1]} = "{text}"'
            for name, text in values.items()
            if name.startswith(group)
        ]
    file = folder / "mine.toml"
    file.write_text("\n".join(lines))
    setup = Setup(values)
    return [values, setup, pickle.loads(pickle.dumps(setup)), Setup.read(file)]


def test_a_stated_value_counts_as_given_in_a_dict_a_setup_and_a_file(tmp_path: Path) -> None:
    """Also a value that is the preset's."""
    shots = "examples/launches.csv"
    file = str(Path(__file__).parents[2] / shots)
    for setup in _setups({"club.loft": "8.8 deg"}, tmp_path):
        found = longdrive.delivery(setup, shots=file)
        assert not any("is the loft of tour-average" in text for text in found.warnings), setup
    advised = longdrive.delivery(None, shots=file).warnings
    assert any("is the loft of tour-average" in text for text in advised)
    for setup in _setups({"ground.turf": "average"}, tmp_path):
        table = {
            "Ball Speed (mph)": [150.0],
            "Launch Angle (deg)": [12.0],
            "Spin Rate (rpm)": [2600.0],
            "Total (yd)": [250.0],
        }
        flown = longdrive.fly(table, setup, of=["total"])
        assert not any("the ground is not given" in text for text in flown.remarks), setup
    own = {"swing.shaft_lean": "2 deg", "strike.high": "6 mm"}
    for setup in _setups(own, tmp_path):
        found = longdrive.optimize(setup, vary={"club.loft": ("4 deg", "20 deg")})
        assert found.advice == "", setup
    assert longdrive.optimize(Setup({"swing.speed": "95 mph"})).advice != ""


def test_a_dict_as_the_second_drive_changes_the_first() -> None:
    first = Setup({"swing.speed": "92 mph", "club.loft": "10.5 deg"})
    change = {"club.loft": "13.5 deg"}
    found = longdrive.compare(first, change)
    assert found == longdrive.compare(first, first.replace(change))
    other = longdrive.compare(first, {"preset": "tour-average", **change})
    assert other == longdrive.compare(first, Setup(change)) != found


def test_a_dict_keeps_the_point_of_the_club_speed() -> None:
    setup = Setup({"swing.speed_of": "face-centre", "swing.closure.z": "2000 deg/s"})
    assert setup["swing.speed_of"] == "face-centre" and "swing.speed_of" in setup
    assert Setup(setup.to_dict()) == setup != setup.replace({"swing.speed_of": "centre-of-mass"})


def test_same_comment_of_a_value_that_did_not_change(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text("[club]\nloft = '9 deg' # new shaft\nmass = '199 g' # weighed\n")
    text = Setup.read(file).replace({"club.loft": "10 deg"}).to_toml()
    assert 'mass = "199 g" # weighed\n' in text
    assert 'loft = "10 deg" # as given, instead of 8.8 deg\n' in text
