"""The studies from Python have the options, messages and numbers of the program."""

from __future__ import annotations

import copy
import json
import pickle
import signal
import subprocess
import sys
import threading
import warnings
from pathlib import Path

import numpy as np
import pytest

import longdrive

FOLDER = Path(__file__).parent.parent
SEARCH = {"vary": {"club.loft": ("4 deg", "20 deg")}, "subject_to": ["descent_angle >= 38 deg"]}


@pytest.fixture
def answered(program):
    """The exit status and the answer of the program to some arguments."""

    def ask(*words):
        done = program(*words, "--json")
        return done.returncode, json.loads(done.stdout)

    return ask


def test_functions_have_the_options_of_the_commands():
    done = subprocess.run(
        [sys.executable, FOLDER / "make_commands.py", "--check"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_same_optimum_as_the_program(answered):
    found = longdrive.optimize("tour-average", **SEARCH)
    status, answer = answered(
        "optimize",
        "tour-average",
        "--vary",
        "club.loft=4 deg..20 deg",
        "--subject-to",
        "descent_angle >= 38 deg",
    )
    assert status == 0
    # the advice names commands, here as functions
    assert "longdrive.delivery()" in found.reply["advice"]
    assert {**found.reply, "advice": answer["advice"]} == answer
    assert (found.fun, dict(zip(found.names, found.x))) == (answer["value"], answer["optimum"])
    assert found.success and found.status == 0 and found.ended == "converged"
    assert found.nit == answer["iterations"] and found.nfev == answer["evaluations"]


def test_a_search_keeps_what_a_dict_states_as_the_program_keeps_what_set_states(answered):
    found = longdrive.optimize({"swing": {"attack_angle": "-2 deg"}})
    status, answer = answered("optimize", "--set", "swing.attack_angle=-2deg")
    assert status == 0 and found.held == answer["held"] == ["swing.attack_angle"]
    assert found.optimum == answer["optimum"] and found.names == ["club.loft"]


def test_a_search_without_stated_parameters_keeps_none():
    setup = longdrive.Setup({"swing.attack_angle": "-2 deg"})
    for found in (
        longdrive.optimize(setup),
        longdrive.optimize(
            {"swing.attack_angle": "-2 deg"}, vary={"swing.attack_angle": ("-5 deg", "5 deg")}
        ),
    ):
        assert found.held == [] and "swing.attack_angle" in found.names


def test_a_value_of_a_dict_that_swings_replace_is_refused_as_by_the_program(answered):
    swings = {"distribution": {"swing.attack_angle": "normal(-1 deg, 1 deg)"}}
    with pytest.raises(longdrive.InputError, match="swing.attack_angle of the setup: the swings"):
        longdrive.optimize({"swing.attack_angle": "-2 deg"}, **swings)
    status, answer = answered(
        "optimize",
        "--set",
        "swing.attack_angle=-2deg",
        "--distribution",
        "swing.attack_angle=normal(-1deg,1deg)",
    )
    assert status == 2 and "the swings have values of it" in answer["message"]
    setup = longdrive.Setup({"swing.attack_angle": "-2 deg"})
    assert longdrive.optimize(setup, **swings).success


STATED = {"swing.speed": "100 mph"}
SPEEDS = {"swing.speed": ("90 mph", "100 mph", 3)}
LAUNCHES = {"ball_speed [mph]": [150], "launch_angle [deg]": [12], "backspin [rpm]": [2600]}


@pytest.mark.parametrize(
    "call",
    [
        lambda: longdrive.batch(STATED, {"swing.speed": [40.0, 45.0]}),
        lambda: longdrive.sweep(STATED, points={"swing.speed [m/s]": [40.0, 45.0]}),
        lambda: longdrive.sweep(STATED, SPEEDS),
        lambda: longdrive.sweep(STATED, SPEEDS, output="speeds.csv"),
        lambda: longdrive.fly(LAUNCHES, STATED),
        lambda: longdrive.calibrate({**LAUNCHES, "carry [yd]": [230]}, STATED, fit="aero.cd0"),
    ],
)
def test_a_value_of_a_dict_that_no_drive_uses_is_refused(call):
    with pytest.raises(longdrive.InputError, match="^swing.speed of the setup: .*leave it out"):
        call()


AIR = {"air.density": 1.1}
LOFT = {"club.loft": "20 deg"}
# a launch in SI, as points of a batch
FLOWN = {
    "launch.ball_speed": [70.0, 71.0],
    "launch.launch_angle": [0.2, 0.2],
    "launch.backspin": [250.0, 260.0],
}
OF_BALL = {**LOFT, "launch": {"ball_speed": 70.0, "launch_angle": 0.2, "backspin": 250.0}}
OVER_SWINGS = ("mean(carry)", "club.loft")


def swings_of(folder, text):
    file = folder / "swings.toml"
    file.write_text(f"[distributions]\n{text}\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda _: longdrive.batch(AIR, {"air.temperature": [280.0, 300.0]}), "both given"),
        (lambda _: longdrive.sweep(AIR, {"air.temperature": (280.0, 300.0, 2)}), "both given"),
        (
            lambda folder: longdrive.sweep(
                AIR, {"air.temperature": (280.0, 300.0, 2)}, output=folder / "rows.csv"
            ),
            "both given",
        ),
        (
            lambda _: longdrive.objective(
                AIR, *OVER_SWINGS, distribution={"air.temperature": ("normal", 290.0, 5.0)}
            ),
            "both given",
        ),
        (
            lambda folder: longdrive.objective(
                {"swing.path": 0.01},
                *OVER_SWINGS,
                swings=swings_of(folder, '"swing.path" = "normal(0deg,2deg)"'),
            ),
            "^swing.path of the setup: the swings have values of it",
        ),
        (lambda _: longdrive.batch(LOFT, FLOWN), "^club.loft of the setup: the points are launches"),
        (
            lambda _: longdrive.sweep(LOFT, points={"launch.ball_speed [m/s]": [70.0]}),
            "^club.loft of the setup: the points are launches",
        ),
        *(
            (call, "^club.loft of the setup: the drive is given by its launch")
            for call in (
                lambda _: longdrive.simulate(OF_BALL),
                lambda _: longdrive.batch(OF_BALL, {"air.density": [1.1]}),
                lambda _: longdrive.sweep(OF_BALL, {"air.density": (1.1, 1.2, 2)}),
                lambda _: longdrive.gradient(OF_BALL, wrt="air.density"),
                lambda _: longdrive.objective(OF_BALL, wrt="air.density"),
                lambda _: longdrive.sensitivity(OF_BALL),
            )
        ),
    ],
)
def test_a_value_of_a_dict_that_others_replace_is_refused_as_by_the_commands(
    call, words, tmp_path
):
    with pytest.raises(longdrive.InputError, match=words):
        call(tmp_path)


def test_every_declared_key_of_an_answer_may_be_in_one(tmp_path):
    flown = longdrive.fly(LAUNCHES)
    swept = longdrive.sweep(over=SPEEDS, output=tmp_path / "rows.csv")
    for found, omitted in ((flown, set()), (swept, {"left_out"})):
        assert set(type(found).__annotations__) - omitted <= set(found)
    assert longdrive.optimize("mae494").command == "optimize"


def test_swings_of_a_delivery_are_a_file_to_write():
    launch = {"ball_speed": 67.0, "launch_angle": "12 deg", "spin": 260.0}
    with pytest.raises(
        longdrive.InputError, match="^swings is a dict; expected the name of a file"
    ):
        longdrive.delivery(**launch, swings={"swing.path": [0.0]})


def test_a_swept_launch_condition_may_be_in_the_dict_of_the_launch():
    launch = {"ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": "2600 rpm"}
    table = longdrive.sweep({"launch": launch}, points={"launch.backspin [rpm]": [2000, 3000]})
    assert table["carry"][0] != table["carry"][1]


def test_messages_of_python_do_not_speak_of_standard_input():
    launch = {"ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": "2600 rpm"}
    with pytest.raises(longdrive.InputError, match="^the launch in the setup: "):
        longdrive.design({"launch": launch})


def test_differences_of_new_searches_confirm_the_price_of_a_constraint():
    limit, step = 42.0, 0.01
    found = longdrive.optimize(subject_to=[f"descent_angle >= {limit} deg"])
    (price,) = (value for name, value in found.prices.items() if name.startswith("descent_angle"))
    relaxed, tightened = (
        longdrive.optimize(subject_to=[f"descent_angle >= {limit + by} deg"]).fun
        for by in (-step, step)
    )
    assert abs(price) > 0
    assert (relaxed - tightened) / (2 * np.radians(step)) == pytest.approx(price, rel=1e-4)


def test_differences_confirm_the_hessian_at_an_optimum():
    found = longdrive.optimize("mae494", vary={"club.loft": (0.1, 0.4)})
    step = 1e-4
    at = [
        longdrive.gradient(
            found.setup.replace({"club.loft": found.x[0] + by}), wrt="club.loft"
        ).gradient[0]
        for by in (step, -step)
    ]
    assert found.hess[0, 0] == pytest.approx((at[0] - at[1]) / (2 * step), rel=1e-6)
    assert abs(found.jac[0]) < 1e-8 * abs(found.hess[0, 0])
    # the attributes are also keys, as in SciPy
    assert found["hess"][0, 0] == found.hess[0, 0] and found["setup"] == found.setup


@pytest.mark.parametrize(
    "search", [longdrive.optimize, longdrive.optimum_sensitivity, longdrive.robust]
)
@pytest.mark.parametrize("form", [dict, lambda launch: [f"{k}={v}" for k, v in launch.items()]])
def test_same_value_and_gradient_at_the_setup_of_a_search_with_a_launch(search, form):
    launch = {"ball_speed": "167 mph", "launch_angle": "10.9 deg", "backspin": "2686 rpm"}
    # this backspin replaces the total spin of the setup
    setup = {"launch": {"ball_speed": 60.0, "launch_angle": 0.3, "spin": 200.0}}
    vary = {"air.density": (1.0, 1.3), "ball.mass": (0.0459, 0.046)}
    found = search(setup, launch=form(launch), vary=vary)
    assert found.setup["launch.spin"] is None
    value, gradient = longdrive.gradient(found.setup, wrt=found.names)
    assert found.fun == pytest.approx(value, rel=1e-9)
    assert found.jac is None or found.jac == pytest.approx(gradient, rel=1e-8)
    stated = longdrive.hessian(
        {f"launch.{name}": text for name, text in launch.items()} | found.optimum, wrt=found.names
    )
    np.testing.assert_allclose(found.hess, stated.hessian, rtol=1e-12)


def test_the_launch_of_a_search_stays_without_a_drive_and_with_a_varied_condition():
    launch = {"ball_speed": 0.05, "launch_angle": -0.7, "backspin": 280.0}
    found = longdrive.optimize(launch=launch, vary={"air.density": (1.0, 1.3)})
    assert found.optimum is None and found.setup["launch.ball_speed"] == 0.05
    launch = {"ball_speed": 70.0, "launch_angle": 0.2, "backspin": 280.0}
    found = longdrive.optimize(launch=launch, vary={"launch.launch_angle": (0.1, 0.4)})
    assert found.setup["launch.ball_speed"] == 70.0
    assert found.setup["launch.launch_angle"] == found.x[0] != 0.2


@pytest.mark.parametrize("accuracy", [{"tolerance": "1 m"}, {"own_step": True}])
def test_same_step_for_the_hessian_as_for_the_search(accuracy):
    setup = longdrive.Setup({"flight.method": "rk4", "flight.step": 0.2})
    found = longdrive.optimize(setup, vary={"club.loft": (0.1, 0.4)}, **accuracy)
    of = (found.setup, "carry", found.names)
    assert found.hess.tolist() == longdrive.hessian(*of, **accuracy).hessian.tolist()
    assert found.hess.tolist() != longdrive.hessian(*of, tolerance="1 um").hessian.tolist()


@pytest.mark.parametrize(
    ("call", "words", "renamed"),
    [
        (
            lambda: longdrive.optimize(vary={"club.lofft": (0.1, 0.2)}),
            ["optimize", "--vary", "club.lofft=0.1..0.2"],
            {"'longdrive parameters'": "longdrive.parameters()"},
        ),
        (lambda: longdrive.optimize(maximize="cary"), ["optimize", "--maximize", "cary"], {}),
        (
            lambda: longdrive.optimize(subject_to="apex_height <= 30"),
            ["optimize", "--subject-to=apex_height <= 30"],
            {"--subject-to": "subject_to"},
        ),
        (
            lambda: longdrive.chart(along="swing.speed=90mph..80mph"),
            ["chart", "--along=swing.speed=90mph..80mph"],
            {},
        ),
        (
            lambda: longdrive.calibrate("missing.csv", fit="aero.cd0"),
            ["calibrate", "missing.csv", "--fit=aero.cd0"],
            {},
        ),
        (
            lambda: longdrive.uncertainty(samples=-3),
            ["uncertainty", "--samples=-3"],
            {"--samples <N>": "samples", "--samples 4096": "samples=4096"},
        ),
        (
            lambda: longdrive.optimize(distribution={"swing.speed": ("normal", 50.0, -1.0)}),
            ["optimize", "--distribution=swing.speed=normal(50.0 m/s,-1.0 m/s)"],
            {},
        ),
        (
            lambda: longdrive.plot.trajectory(width=10),
            ["plot", "trajectory", "-o", "x.svg", "--width=10"],
            {"--width <PIXELS>": "width", "--width 800": "width=800"},
        ),
        (lambda: longdrive.reproduce("nobody"), ["reproduce", "nobody"], {"<STUDY>": "study"}),
    ],
)
def test_bad_input_gets_the_programs_message(call, words, renamed, answered):
    status, answer = answered(*words)
    assert (status, answer["status"]) == (2, "error")
    message = answer["message"]
    for option, argument in renamed.items():
        assert option in message
        message = message.replace(option, argument)
    with pytest.raises(longdrive.InputError) as raised:
        call()
    assert str(raised.value) == message


def test_a_request_without_an_answer_raises_with_its_status():
    with pytest.raises(longdrive.NoAnswerError) as raised:
        longdrive.sensitivity({"preset": "tour-average", "swing.attack_angle": "-40 deg"})
    assert raised.value.status == "no-flight"


def test_an_infeasible_search_has_its_status_and_raises_nothing():
    found = longdrive.optimize(subject_to=["carry >= 500 m"])
    assert (found.success, found.ended) == (False, "infeasible")
    assert found.message


def test_exact_maxcv_is_the_constraint_violation():
    missed = longdrive.optimize(subject_to=["carry >= 500 m"])
    (row,) = missed.constraints
    assert (
        missed.maxcv == row["violation"] == pytest.approx(500 - row["value"], abs=1e-9)
        and missed.maxcv > 100
    )
    assert longdrive.optimize(subject_to=["descent_angle >= 42 deg"]).maxcv < 1e-9
    assert longdrive.optimize("mae494").maxcv == 0.0


def test_a_setup_object_keeps_every_digit(answered):
    setup = longdrive.Setup("tour-average").replace(
        {"swing.speed": 50.123456789012345, "club.loft": 0.1718281828459045}
    )
    (row,) = longdrive.sensitivity(setup, of="carry").outcomes
    assert row["value"] == longdrive.gradient(setup, wrt="all", own_step=True).value
    status, answer = answered(
        "optimize",
        "tour-average",
        "--set=swing.speed=50.123456789012345 m/s",
        "--set=club.loft=0.1718281828459045 rad",
        "--vary=club.loft=4deg..20deg",
        "--vary=swing.attack_angle=-5deg..5deg",
    )
    # the answer of the program also names the setup as stated on the command line, and its advice
    # names commands of the program
    del answer["from"], answer["advice"]
    found = dict(longdrive.optimize(setup).reply)
    del found["advice"]
    assert (status, found) == (0, answer)


def test_a_stated_step_is_kept_in_a_command():
    setup = longdrive.Setup(
        {"preset": "modern-driver", "flight.method": "rk4", "flight.step": 0.05}
    )
    found = longdrive.optimize(setup, vary={"club.loft": (0.1, 0.3)})
    assert found.fun == longdrive.gradient(found.setup, wrt="club.loft").value


def test_same_request_from_numbers_pairs_and_texts():
    texts = longdrive.optimize(vary=["club.loft=0.1 rad..0.3 rad"])
    numbers = longdrive.optimize(vary={"club.loft": (0.1, 0.3)})
    assert texts.reply == numbers.reply


class Degrees:
    """A quantity like pint's."""

    def __init__(self, magnitude: float) -> None:
        self.magnitude, self.units = magnitude, "degree"

    def to(self, unit: str) -> Degrees:
        assert unit == "rad"
        turned = Degrees(np.radians(self.magnitude))
        turned.units = "radian"
        return turned


def test_quantities_of_pint_are_converted():
    quantities = longdrive.optimize(vary={"club.loft": (Degrees(4.0), Degrees(20.0))})
    texts = longdrive.optimize(
        vary={"club.loft": (float(np.radians(4.0)), float(np.radians(20.0)))}
    )
    assert quantities.reply == texts.reply


SHOTS = {
    "ball_speed [m/s]": [60.0, 65.0, 70.0, 75.0],
    "launch_angle [deg]": [10.0, 11.0, 12.0, 13.0],
    "backspin [rpm]": [2500.0, 2600.0, 2700.0, 2800.0],
}


def flown(cd0: float) -> list[float]:
    """Carries of the launches in SHOTS for a ball with this drag, m."""
    rows = zip(*SHOTS.values())
    launch = [
        {
            "launch.ball_speed": v,
            "launch.launch_angle": f"{a} deg",
            "launch.backspin": f"{s} rpm",
            "launch.sidespin": 0,
            "launch.launch_direction": 0,
        } for v, a, s in rows
    ]
    base = {"preset": "modern-driver", "aero.law": "robinson", "aero.cd0": cd0}
    return [longdrive.simulate({**base, **row})["carry"] for row in launch]


def test_exact_coefficient_recovered_from_shots_in_a_dict_a_file_and_a_data_frame(tmp_path):
    shots = {**SHOTS, "carry [m]": flown(0.31)}
    file = tmp_path / "shots.csv"
    file.write_text(
        "\n".join([",".join(shots), *(",".join(map(repr, row)) for row in zip(*shots.values()))]),
        encoding="utf-8",
    )
    tables: list[object] = [shots, {name: np.array(column) for name, column in shots.items()}, file]
    pandas = pytest.importorskip("pandas")
    tables.append(pandas.DataFrame(shots))
    setup = {"preset": "modern-driver", "aero.law": "robinson"}
    for table in tables:
        found = longdrive.calibrate(table, setup, fit="aero.cd0=0.1..0.5")
        (estimate,) = (row["value"] for name, row in found.estimates.items() if name == "aero.cd0")
        assert estimate == pytest.approx(0.31, abs=1e-6), type(table)


def test_columns_of_different_length_are_named():
    with pytest.raises(longdrive.InputError, match="its columns have 1 and 2 rows"):
        longdrive.calibrate({"carry [m]": [1.0], "ball_speed [m/s]": [1.0, 2.0]}, fit="aero.cd0")


def test_shots_come_back_row_by_row():
    answer = longdrive.fly(
        {
            "ball speed [mph]": [160.0, 150.0],
            "launch angle [deg]": [12.0, 13.0],
            "spin [rpm]": [2600.0, None],
        }
    )
    assert [shot["flight"] for shot in answer.shots] == ["landed", "refused"]
    assert "every launch needs a spin" in answer.shots[1]["reason"]


def test_pictures_are_svg_and_are_saved(tmp_path):
    picture = longdrive.plot.trajectory("tour-average")
    assert picture.svg.startswith("<svg") and picture._repr_html_() == picture.svg
    assert picture.save(tmp_path / "drive.svg").read_text(encoding="utf-8") == picture.svg
    with pytest.raises(ValueError, match="make the plot with output="):
        picture.save(tmp_path / "drive.png")
    image = longdrive.plot.trajectory("tour-average", output=tmp_path / "drive.png")
    assert image._repr_png_().startswith(b"\x89PNG")


def test_warnings_point_at_the_calling_line():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        answer = longdrive.chart(
            {"aero.law": "smits-smith"},
            along={"swing.speed": ("80 mph", "90 mph")},
            vary={"club.loft": (0.1, 0.3)},
        )
    assert [str(warning.message) for warning in caught] == ["\n".join(answer.warnings)]
    assert answer.warnings and {warning.filename for warning in caught} == {__file__}
    assert {warning.category for warning in caught} == {longdrive.LongdriveWarning}


def test_a_progress_function_is_called():
    seen: list[tuple[int, int]] = []
    longdrive.uncertainty(samples=4096, progress=lambda done, of: seen.append((done, of)))
    assert seen and all(0 <= done <= of for done, of in seen)


def test_answers_pickle_and_copy():
    found = longdrive.optimize("mae494")
    for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert type(again) is longdrive.Optimum
        assert (
            again.reply == found.reply and again.setup == found.setup and (again.x == found.x).all()
        )
    answer = longdrive.sensitivity()
    assert pickle.loads(pickle.dumps(answer)) == answer
    picture = longdrive.plot.trajectory()
    assert pickle.loads(pickle.dumps(picture)).svg == picture.svg


def test_answers_show_themselves_in_notebooks():
    found = longdrive.optimize("mae494")
    assert "<table>" in found._repr_html_() and "club.loft" in found._repr_html_()
    assert "fun" in repr(found) and "kkt_residual" in dir(found)
    with pytest.raises(AttributeError, match="it has x, names, fun"):
        found.nothing_of_this_name


def test_ctrl_c_ends_a_search_early():
    is_at_work = threading.Event()

    def press_ctrl_c() -> None:
        is_at_work.wait()
        signal.raise_signal(signal.SIGINT)

    presser = threading.Thread(target=press_ctrl_c, daemon=True)
    presser.start()
    with pytest.raises(longdrive.Interrupted) as caught:
        # minutes of work
        longdrive.optimize(
            distribution={
                "swing.speed": ("normal", 50.0, 1.5),
                "swing.path": ("normal", 0.0, 0.04),
                "strike.toe": ("normal", 0.0, 0.01),
                "strike.high": ("normal", 0.0, 0.01),
            },
            vary={
                name: low_high for name, low_high in {
                    "club.loft": (0.1, 0.3),
                    "club.bulge_radius": (0.2, 0.6),
                    "club.roll_radius": (0.2, 0.6),
                }.items()
            },
            maximize="mean(carry) - 0.5*std(lateral)",
            scenarios=100_000,
            starts=2,
            progress=lambda done, of: is_at_work.set(),
        )
    presser.join()
    # the exception has an answer, unless the search had no result yet
    assert caught.value.answer is None or caught.value.answer.ended == "interrupted"
    assert longdrive.optimize("mae494").success


def test_two_searches_at_once_do_not_disturb_each_other():
    found: dict[str, float] = {}
    work = [
        threading.Thread(
            target=lambda name=name: found.__setitem__(name, longdrive.optimize(name, starts=4).fun)
        )
        for name in ("mae494", "tour-average")
    ]
    for thread in work:
        thread.start()
    for thread in work:
        thread.join()
    assert found == {name: longdrive.optimize(name, starts=4).fun for name in found}


def test_the_package_contains_the_program():
    done = subprocess.run(
        [sys.executable, "-m", "longdrive", "presets"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0 and "tour-average" in done.stdout
    refused = subprocess.run(
        [sys.executable, "-m", "longdrive", "simulate", "--set", "x=1"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode == 2 and "x" in refused.stderr
