"""Sensitivities of whole scenes: closed forms, laws of similarity, events, and what a user is told."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.design.differences import Side, Slope
from tmmcalc.design.ladders import Reach
from tmmcalc.design.sensitivity import Partial, Sensitivity, sensitivity
from tmmcalc.design.sensitivity_document import sensitivity_document
from tmmcalc.naming.keys import keys_of
from tmmcalc.project.loader import Variants

CONFIGS = Path(__file__).parents[2] / "configs"
SHAPER = CONFIGS / "shaper.toml"
CRANK, AXIS, SLOTTED = (
    "mechanism.links[id=1].points.A[0]",
    "mechanism.fixed.O[1]",
    "mechanism.links[id=3].points.C[0]",
)


def of(result: Sensitivity, name: str) -> dict[str, Partial]:
    return {each.key.partition("[mm]")[0]: each for each in result.partials if each.name.startswith(name)}


def test_the_stroke_of_a_shaper_in_closed_form() -> None:
    """H = 2 l_3 l_1 / l_0: per cent for per cent."""
    told = of(sensitivity(SHAPER, ["kinematics.stroke_D"], [CRANK, AXIS, SLOTTED]), "kinematics.stroke_D")
    for key, power in ((CRANK, 1), (SLOTTED, 1), (AXIS, -1)):
        assert told[key].relative == pytest.approx(power, rel=1e-11)
        assert told[key].error < 1e-11


def test_angles_of_dead_centres_move() -> None:
    """The working angle of a slotted link is pi + 2 asin(l_1/l_0), an event that moves with its lengths."""
    told = of(sensitivity(SHAPER, ["kinematics.working_D"], [CRANK, AXIS]), "kinematics.working_D")
    ratio = 200 / 620
    by_ratio = math.degrees(2 / math.sqrt(1 - ratio**2))
    assert told[CRANK].slope.value == pytest.approx(by_ratio / 620, rel=1e-9)
    assert told[AXIS].slope.value == pytest.approx(-by_ratio * ratio / 620, rel=1e-9)


def test_laws_of_similarity() -> None:
    """Speeds go with that of the crank, accelerations with its square; forces of weights alone with gravity."""
    names = ["kinematics.max(vS_D)", "kinematics.max(aS_D)", "kinematics.stroke_D"]
    result = sensitivity(SHAPER, names, ["mechanism.input.speed"])
    told = {each.name.partition("[")[0]: each.relative for each in result.partials}
    assert [told[name] for name in names] == pytest.approx([1, 2, 0], abs=1e-11)


@pytest.mark.slow
def test_events_that_jump_and_sides_are_told() -> None:
    """A load that begins at a row of the table is there or not."""
    result = sensitivity(SHAPER, ["forces.max(R_A)"], ["loads[name=Q5].between[0]", CRANK])
    sides = {each.key: each.slope.side for each in result.partials}
    assert sides == {"loads[name=Q5].between[0][deg]": "jump", f"{CRANK}[mm]": "both"}


def test_an_end_of_what_assembles_is_told(tmp_path: Path) -> None:
    """A four-bar at the end of what turns fully: a small step to one side has no turn."""
    spec = tmp_path / "short.toml"
    text = (CONFIGS / "four-bar.toml").read_text(encoding="utf-8")
    spec.write_text(text, encoding="utf-8")
    length = "mechanism.links[id=2].points.B[0]"
    # the longest and the shortest link together are nearly as long as the other two
    result = sensitivity(spec, ["kinematics.stroke_3"], [length], [f'{length}="899.9 mm"'])
    (partial,) = result.partials
    assert result.reaches or partial.slope.side != "both"


def test_all_numbers_are_found_and_read_as_overrides() -> None:
    data = Variants(SHAPER.read_text(encoding="utf-8"), str(SHAPER), SHAPER.parent).data
    keys = keys_of(data)
    assert {CRANK, AXIS, "motor.power", "loads[name=Q5].force", "mechanism.joints[name=A3].friction"} <= {*keys}
    assert not any(key.startswith("project") for key in keys)


def test_keys_that_there_are_not(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no number of the spec"):
        sensitivity(SHAPER, ["kinematics.stroke_D"], ["links*"])
    with pytest.raises(UsageError, match="no quantity is called 'strok'") as caught:
        sensitivity(SHAPER, ["strok"], [CRANK])
    assert "kinematics.stroke_D" in caught.value.remedy
    with pytest.raises(UsageError, match="not a whole number"):
        sensitivity(SHAPER, ["kinematics.stroke_D"], ["mechanism.grid.positions"])


@pytest.mark.parametrize(
    ("config", "name", "keys"),
    [
        ("shaper.toml", "motion.delta", ["flywheel.inertia", "loads[name=Q5].force"]),
        pytest.param("pair-spur.toml", "pair.*", ["pair*"], marks=pytest.mark.slow),
        pytest.param("cam.toml", "cam_synthesis.*", ["cam*"], marks=pytest.mark.slow),
        ("extra-bearing.toml", "bearing.*", ["bearing*"]),
    ],
)
def test_rooms_are_all_alike(config: str, name: str, keys: list[str]) -> None:
    """What has a derivative has it to the aim, whatever it is of."""
    result = sensitivity(CONFIGS / config, [name], keys)
    settled = [each for each in result.partials if each.slope.side == "both" and each.slope.value]
    large = [each for each in settled if abs(each.relative) > 1e-6]
    assert large
    assert max(each.error for each in large) < 1e-6


def test_what_is_rounding_and_from_where_there_is_no_solution_is_told() -> None:
    """A derivative that does less than 1e-9 of the largest is none; of a number that is 0 it may be anything."""

    def partial(key: str, value: float, slope: float, side: Side = "both") -> Partial:
        return Partial("r[N]", f"{key}[mm]", value, Slope(slope, 0.0, side, slope, slope, 0.0), 1.0)

    every = (partial("a", 10.0, 2.0, "right"), partial("b", 10.0, 1e-10), partial("c", 0.0, 1e-10))
    reaches = (Reach("a[mm]", -0.25, "open"), Reach("b[mm]", -0.1, "open"))
    found = sensitivity_document(Sensitivity(("r[N]",), (1.0,), every, reaches, (), 9), "t").parts[0]
    assert found.table is not None
    assert [*found.table.columns[0]] == ["a", "c"]
    assert [note for note in found.notes if "no solution" in note] == [
        "note: a[mm]: to smaller values there is no solution from 0.25 mm on"
    ]
