"""The key of a variant: right values in the asked units, mistakes that change nothing, classes, clashes, faults."""

from __future__ import annotations

import math
import time
from dataclasses import replace

import pytest
from mistakes import CONFIGS, item, items, key

from tmmcalc.classroom.bench import Bench
from tmmcalc.classroom.keying import Desk, clashes, classes_of, key_of, mistakes_of, told_of
from tmmcalc.classroom.model import Key
from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.naming.language import parse
from tmmcalc.naming.told import one
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

TEN = items(
    *("kinematics.stroke_D mm", "kinematics.vS_D@5 m/s", "kinematics.aS_D@5 m/s^2", "kinematics.omega_3@5 rad/s"),
    *("forces.R_A@5 N", "forces.M_drive@5 N*m", "reduction.M_red@5 N*m", "power.eta ", "power.P_required W"),
    "flywheel.J_add kg*m^2",
)
NAN = math.nan


def test_right_values_are_those_of_a_run_in_the_asked_units() -> None:
    spec = load_spec(CONFIGS / "shaper.toml")
    asked = items("kinematics.stroke_D mm", "kinematics.angle_3@5 rad", "power.P_mean kW", "kinematics.K_D ")
    results = run(spec, target="power").results
    values = [one(parse(each.result), results).value for each in asked]
    factors = (1e3, math.pi / 180, 1e-3, 1)
    assert key("shaper", asked).values == pytest.approx([a * b for a, b in zip(values, factors, strict=True)])


def test_mistakes_that_a_scene_has_not_are_not_listed() -> None:
    names = {scene: {told.name for told in mistakes_of(load_spec(CONFIGS / f"{scene}.toml"))} for scene in
             ("shaper", "crank-slider", "pair-spur", "cam", "class-three")}  # fmt: skip
    assert "linkage.coriolis_left_out" in names["shaper"]
    assert "linkage.coriolis_left_out" not in names["crank-slider"] | names["pair-spur"]
    assert {"linkage.other_assembly:2-3", "linkage.other_assembly:4-5"} == {
        each for each in names["shaper"] if "assembly" in each
    }
    assert not any("assembly" in each for each in names["class-three"])
    assert "gears.module_doubled" in names["pair-spur"]
    assert "gears.module_doubled" not in names["shaper"]
    assert "cams.cam_turned_back" in names["cam"]
    assert "machine.links_left_out" not in names["crank-slider"]
    assert all("classroom.sense_reversed" in each for each in names.values())


def test_what_a_mistake_does_not_change_has_no_value() -> None:
    asked = items("kinematics.stroke_D mm", "kinematics.vS_D@3 m/s", "kinematics.aS_D@3 m/s^2")
    found = key("shaper", asked, "linkage.coriolis_left_out", "linkage.weights_left_out", "linkage.analogue_given")
    changed = [[math.isfinite(value) for value in values] for values in found.mistaken]
    assert changed == [[False, False, True], [False] * 3, [False, True, True]]


def test_the_other_sense_is_right_where_it_is_left_open() -> None:
    asked = (item("kinematics.vS_D@3", "m/s", either=True),)
    found = key("shaper", asked, "classroom.sense_reversed", "classroom.other_length_unit")
    assert math.isnan(found.mistaken[0][0])
    assert found.mistaken[1][0] == pytest.approx(1e3 * found.values[0])
    assert clashes(found, asked) == ()


def test_a_mistake_without_a_solution_is_no_traceback() -> None:
    """Of a pair whose module is doubled the given centre distance is too short; downstream nothing is told."""
    sets = ('pair.centre_distance="85 mm"',)
    asked = items("pair.a_w mm", "pair.eps_alpha ")
    assert all(map(math.isnan, key("pair-helical", asked, "gears.module_doubled", sets=sets).mistaken[0]))


def test_faults_of_the_right_solution_are_told() -> None:
    with pytest.raises(UsageError, match=r"power\.P_mean is in W and cannot be asked in mm"):
        key("shaper", items("power.P_mean mm"))
    with pytest.raises(UsageError, match="tells no 'no_such'"):
        key("shaper", items("power.no_such W"))
    with pytest.raises(TmmError):
        key("crank-slider", items("kinematics.stroke_B m"), sets=('mechanism.links[id=2].points.B[0]="20 mm"',))


def made(*mistaken: tuple[float, ...], right: tuple[float, ...] = (10.0, 20.0)) -> Key:
    return Key(1, "", right, mistaken)


def test_mistakes_that_agree_within_tolerance_are_one_class() -> None:
    asked = (item("a", ""), item("b", ""))
    told = [told_of("linkage.coriolis_left_out")] * 4 + [told_of("classroom.sense_reversed")]
    found = made((12, NAN), (12.05, 20.1), (NAN, NAN), (12.3, NAN), (12, NAN))
    assert classes_of(found, asked, told) == ((0, 1), (3,), (4,))
    wide = (replace(asked[0], within=0.5), asked[1])
    assert classes_of(found, wide, told) == ((0, 1, 3), (4,))


def test_a_clash_is_a_wrong_way_to_a_right_answer() -> None:
    asked = (item("a", ""), item("b", "", either=True))
    assert clashes(made((10.05, 25), (11, -20.1), (NAN, NAN)), asked) == ((0, 0), (1, 1))


def test_a_bench_takes_what_a_mistake_leaves_as_it_is() -> None:
    spec = load_spec(CONFIGS / "press.toml")
    bench = Bench(spec, ("flywheel",))
    assert bench.unchanged(bench.scene())
    lighter = load_spec(CONFIGS / "press.toml", ("mechanism.gravity=0",))
    results, right = bench.scene(lighter).results, bench.scene().results
    assert results["kinematics"] is right["kinematics"]
    assert results["reduction"] is not right["reduction"]


def test_a_stage_that_breaks_ends_only_what_needs_it() -> None:
    def broken(solve: object, *given: object, **upstream: object) -> None:
        raise ZeroDivisionError

    def hopeless(solve: object, *given: object, **upstream: object) -> None:
        raise NoSolutionError("no")

    bench = Bench(load_spec(CONFIGS / "press.toml"), ("kinematics", "power", "flywheel"))
    for wrong in (broken, hopeless):
        assert [*bench.scene(amiss={"power": wrong}).results] == ["structure", "kinematics", "reduction"]


@pytest.mark.slow
def test_the_key_of_a_course_project() -> None:
    spec = load_spec(CONFIGS / "course-project.toml")
    told = mistakes_of(spec)
    began = time.process_time()
    found = key_of(1, "", spec, TEN, told)
    assert time.process_time() - began < 20  # some 5 s of one processor
    telling = {each.name for each, values in zip(told, found.mistaken, strict=True) if any(map(math.isfinite, values))}
    assert len(telling) > 45
    assert {"linkage.friction_reversed", "machine.links_left_out", "classroom.position_after"} <= telling
    assert len(classes_of(found, TEN, told)) > 40
    desk, wanted = Desk(spec, TEN), {0, 3, 7}
    assert desk.values == found.values
    for each, values in [*zip(told, found.mistaken, strict=True)][::5]:
        some = tuple(value if at in wanted else math.nan for at, value in enumerate(values))
        assert desk.mistaken(each.name, wanted) == pytest.approx(some, rel=1e-12, nan_ok=True)
        assert all(math.isnan(value) for value in desk.mistaken(each.name, ()))
