"""Every form of a name against what is computed directly from the results."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.through import between, integral
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import Told, one, unknown
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"


@pytest.fixture(scope="module")
def scene() -> RunResult:
    return run(tmmcalc.load_spec(SHAPER), target=("kinematics", "forces", "reduction", "motion"))


def told(scene: RunResult, text: str) -> Told:
    name = parse(text)
    return one(name, scene.results, Scene(scene.spec, scene.results))


def column(scene: RunResult, stage: str, header: str) -> np.ndarray:
    table = scene.table(stage)
    assert table is not None
    return np.asarray(table.columns[table.header.index(header)], float)


def test_a_fact_with_and_without_its_stage(scene: RunResult) -> None:
    omega = scene.results["motion"].regime
    for text in ("motion.delta", "delta"):
        found = told(scene, text)
        assert (found.value, found.key, found.unit) == (omega.delta, "motion.delta", "")
    assert "speed fluctuation" in found.meaning
    assert told(scene, "stroke_D[m]").value == scene.results["kinematics"].summaries[0].stroke


@pytest.mark.parametrize(
    ("of", "wanted"),
    [
        ("max", lambda r: r.max()),
        ("min", lambda r: r.min()),
        ("range", lambda r: r.max() - r.min()),
        ("size", lambda r: abs(r).max()),
        ("mean", lambda r: r.sum() / len(r)),
        ("rms", lambda r: (r @ r / len(r)) ** 0.5),
        ("first", lambda r: r[0]),
        ("last", lambda r: r[-1]),
    ],
)
def test_what_is_asked_of_rows(scene: RunResult, of: str, wanted) -> None:
    values = column(scene, "forces", "R_A_x[N]")
    assert told(scene, f"forces.{of}(R_A_x)").value == pytest.approx(wanted(values), rel=1e-14)
    some = told(scene, f"{of}(R_A_x)@2..12")
    assert some.value == pytest.approx(wanted(values[2:13]), rel=1e-14)
    assert (some.key, some.how) == (f"forces.{of}(R_A_x)@2..12[N]", "of 11 rows")


def test_where_extremes_are(scene: RunResult) -> None:
    phi, values = column(scene, "forces", "phi[deg]"), column(scene, "forces", "R_A_x[N]")
    for of, place in (("at_max", values.argmax()), ("at_min", values.argmin()), ("at_size", abs(values).argmax())):
        found = told(scene, f"forces.{of}(R_A_x)")
        assert (found.value, found.unit) == (phi[place], "deg")


def test_a_row_by_its_label_and_by_its_angle(scene: RunResult) -> None:
    values = column(scene, "kinematics", "S_D[m]")
    assert told(scene, "S_D@12").value == values[12]
    assert told(scene, "S_D[phi=180 deg]").value == values[12]
    assert told(scene, "S_D[phi=-180]").value == values[12]
    assert told(scene, "S_D[phi=180 deg]").how == "row 12"


@pytest.mark.parametrize("name", ["kinematics.vS_D", "kinematics.x_C", "forces.R_A", "reduction.J_red"])
@pytest.mark.parametrize("angle", [50.0, 47.3, 311.0])
def test_between_rows_it_is_computed(scene: RunResult, name: str, angle: float) -> None:
    """The same scene with a position at this angle, given to the program as a user would."""
    grid = re.sub(r"(positions = \d+)", rf'\1\nextra = ["{angle} deg"]', SHAPER.read_text(), count=1)
    stage, _, what = name.partition(".")
    whole = run(tmmcalc.parse_spec(grid), target=stage)
    phi = column(whole, stage, "phi[deg]")
    there = int(np.argmin(abs(phi - angle)))
    assert phi[there] == pytest.approx(angle, abs=1e-9)
    table = whole.table(stage)
    assert table is not None
    header = next(each for each in table.header if each.partition("[")[0] == what)
    found = told(scene, f"{name}[phi={angle} deg]")
    assert found.how == "computed there"
    assert found.value == pytest.approx(column(whole, stage, header)[there], rel=1e-12)
    turned = told(scene, f"{name}[phi={float(np.radians(angle - 360))!r} rad]")
    assert turned.value == pytest.approx(found.value, rel=1e-9)


def test_a_clockwise_crank_and_a_part_of_a_turn() -> None:
    spec = tmmcalc.load_spec(SHAPER, ["mechanism.input.speed=-5.76", "mechanism.grid.span='90 deg'"])
    scene = run(spec, target="kinematics")
    found = told(scene, "kinematics.y_A[phi=-50 deg]")
    pivot = complex(*spec.mechanism.fixed["O"])
    first = complex(*(column(scene, "kinematics", f"{axis}_A[m]")[0] for axis in "xy")) - pivot
    assert abs(first) == pytest.approx(scene.results["kinematics"].crank_length)
    assert found.value == pytest.approx((pivot + first * np.exp(-1j * np.radians(50))).imag, abs=1e-12)
    with pytest.raises(UsageError, match="has no row about phi = 50 deg"):
        told(scene, "kinematics.y_A[phi=50 deg]")


def test_where_nothing_can_be_computed_the_cubic_says_how_good_it_is(scene: RunResult) -> None:
    found = told(scene, "motion.t[phi=50 deg]")
    assert found.how.startswith("cubic through the rows, off by about ")
    phi, t = column(scene, "motion", "phi[deg]"), column(scene, "motion", "t[s]")
    assert found.value == pytest.approx(np.interp(50, phi, t), rel=1e-2)


def test_a_cubic_and_its_integral_are_exact_for_cubics() -> None:
    x = np.array([0.0, 0.3, 1.0, 1.1, 2.0, 3.0])
    y = 2 * x**3 - x
    assert between(x, y, 1.7, False)[0] == pytest.approx(2 * 1.7**3 - 1.7, rel=1e-13)
    for sense in (1, -1):
        assert integral(sense * x, y, False) == pytest.approx(sense * (81 / 2 - 9 / 2), rel=1e-13)


def test_no_cubic_reaches_over_a_jump() -> None:
    x = np.array([0.0, 1.0, 2.0, 2.0, 3.0, 4.0])
    y = np.array([1.0, 1.0, 1.0, 5.0, 5.0, 5.0])
    assert (between(x, y, 1.9, False)[0], between(x, y, 2.1, False)[0]) == pytest.approx((1.0, 5.0))
    assert integral(x, y, False) == pytest.approx(12.0)


def test_around_a_turn_the_integral_has_the_accuracy_of_the_trapezoid_rule(scene: RunResult) -> None:
    x = np.linspace(0, 2 * np.pi, 25)
    exact = 2 * np.pi / np.sqrt(3)  # of 1/(2 + cos x)
    assert integral(x, 1 / (2 + np.cos(x)), True) == pytest.approx(exact, rel=1e-12)
    found, inertia = told(scene, "reduction.integral(J_red)"), column(scene, "reduction", "J_red[kg*m^2]")
    assert (found.unit, found.value) == (
        "kg*m^2*rad",
        pytest.approx(inertia[:-1].sum() * 2 * np.pi / 24, rel=1e-12),
    )


def test_a_range_of_angles_has_its_ends(scene: RunResult) -> None:
    dense = run(tmmcalc.load_spec(SHAPER, ["mechanism.grid.positions=3600"]), target="kinematics")
    ends = [told(dense, f"kinematics.S_D[phi={angle} deg]").value for angle in (50, 200)]
    speed = scene.results["kinematics"].speed
    found = told(scene, "kinematics.integral(vS_D)[phi=50 deg..200 deg]")
    assert found.value / speed == pytest.approx(ends[1] - ends[0], rel=2e-3)
    assert told(scene, "kinematics.first(S_D)[phi=50 deg..200 deg]").value == pytest.approx(ends[0], rel=1e-10)
    assert told(scene, "kinematics.last(S_D)[phi=50 deg..200 deg]").value == pytest.approx(ends[1], rel=1e-10)


WRONG = {
    "kinematics.strok_D": ("kinematics tells no 'strok_D'", "stroke_D"),
    "kinmatics.stroke_D": ("no quantity is called 'kinmatics.stroke_D'", "kinematics.stroke_D"),
    "forces.R_A": ("forces.R_A is a column", "max(R_A)"),
    "max(R_Q)": ("no quantity is called 'max(R_Q)'", "forces.R_"),
    "max(phi)": ("is told by several stages: kinematics, forces, reduction, motion", "kinematics.max(phi)"),
    "power.eta": ("this scene has no cam_law", ""),
    "max(R_*)": ("may name several quantities", "without *"),
    "S_D@77": ("has no row '77'", "0, 1, 2"),
    "max(S_D)@12..2": ("has row 2 before row 12", "earlier row first"),
    "S_D[phi=1 m]": ("'1 m' is no number in deg", "in deg"),
    "S_D[phi=nan]": ("has no row about", "0 to 360"),
    "S_D[t=1]": ("stands in no table with a column 't'", "phi"),
    "x_C[S_D=-0.1]": ("does not run one way", "phi"),
    "max(S_D)[phi=200..100]": ("ends at 100 deg, and begins at 200", "smaller value first"),
    "at_max(S_D)@3": ("is asked of one row", "@2..12"),
    "forces.chosen(R_A)": ("has no rows to choose from", "criteria"),
}


def test_a_pattern_that_names_nothing_is_told_in_a_few_words(scene: RunResult) -> None:
    remedy = unknown(parse("forces.qqq*"), scene.results, Scene(scene.spec, scene.results)).remedy
    assert remedy.endswith("more, see tmmcalc names")
    assert "stroke_D" not in remedy
    assert len(remedy) < 600
    assert unknown(parse("forces.max(R_OO*)"), scene.results).remedy == "did you mean R_O, R_O_y, R_O_x?"


def test_meanings_are_of_what_they_name(scene: RunResult) -> None:
    assert told(scene, "forces.M_drive_max").meaning == "largest drive along the positive input coordinate"
    assert told(scene, "forces.R_A_max_at_phi").meaning == "largest reaction in A: phi there"


def test_the_ends_of_a_column_are_of_the_column() -> None:
    """Of the law of the input S_1 is the way of a phase; output 1 has a column of this name."""
    whole = run(tmmcalc.load_spec(SHAPER.with_name("crane-luffing.toml")), target=("unsteady",))
    assert told(whole, "unsteady.S_1").meaning == "way of each of the outer phases"
    assert told(whole, "unsteady.S_1_start").meaning.startswith("coordinate of output 1")
    assert told(whole, "unsteady.S_1_end").unit == "deg"


def test_columns_have_meanings() -> None:
    whole = run(tmmcalc.load_spec(SHAPER, ["motion.inertia=100"]), target=("balance",))
    assert told(whole, "balance.max(M_R)").meaning == "shaking moment about the chosen point: max"


@pytest.mark.parametrize("text", WRONG)
def test_what_is_not_there_is_told(scene: RunResult, text: str) -> None:
    asked = "cam_law.x" if text == "power.eta" else text
    message, remedy = WRONG[text]
    with pytest.raises(UsageError) as refused:
        told(scene, asked)
    assert message in refused.value.message
    assert remedy in refused.value.remedy
