"""What is said of the cutter of a ring at the level of the pair, in millimetres."""

import re

import pytest

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.meshing.cutting import NAMES
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

M = 0.002


def inside(shifts=(0.0, 0.0), refuse=True, **cutter) -> PairTask:
    if "diameter" in cutter:
        cutter["tip"] = cutter.pop("diameter") / 2e3 / M
    return PairTask(
        (20, 60), M, kind="internal", strategy="given", shifts=shifts, cutter=Cutter(**cutter), refuse=refuse
    )


def told(task: PairTask) -> NoSolutionError:
    with pytest.raises(NoSolutionError) as error:
        solve_pair(task)
    return error.value


def numbers(text: str) -> list[float]:
    return [float(each) for each in re.findall(r"(-?\d+\.?\d*) mm", text)]


@pytest.mark.parametrize("diameter", [56, 60, 64, 500])
def test_tip_narrower_than_its_rounding(diameter):
    error = told(inside(teeth=25, shift=0.1, rounding=0.2, diameter=diameter))
    assert f"the tip of the cutter, {diameter} mm in diameter, is narrower than its rounding of 0.4 mm" in error.message
    assert error.value < 0
    low, high = numbers(error.remedy)
    for sound in (low, high - 1e-4):
        assert solve_pair(inside(teeth=25, shift=0.1, rounding=0.2, diameter=sound + 5e-5)).verdict == "warn"


def test_pointed_tip():
    assert "is pointed (margin" in told(inside(teeth=25, shift=0.1, diameter=57)).message


@pytest.mark.parametrize(
    ("diameter", "said"), [(40, "lies within its base circle, 46.9846 mm"), (50, "leaves the ring")]
)
def test_shallow_cutters_are_the_cause(diameter, said):
    error = told(inside(teeth=25, shift=0.1, rounding=0.2, diameter=diameter))
    assert error.message.startswith("the ")
    assert said in error.message
    assert "gear 1 lies within its base circle" not in error.message
    assert "nearest admissible shifts" not in error.remedy
    least = numbers(error.remedy)[0]
    assert solve_pair(inside(teeth=25, shift=0.1, rounding=0.2, diameter=least + 1e-3)).note.count("pinion") == 1


def test_short_teeth_of_the_pinion_are_told():
    found = solve_pair(inside(teeth=25, shift=0.1, rounding=0.2, diameter=54))
    cut = 22e-3 - found.sizes[0].tip
    assert cut == pytest.approx(0.7046e-3, abs=1e-6)
    assert f"the teeth of the pinion are {1e3 * cut:.6g} mm shorter" in found.note
    assert next(check for check in found.checks if check.name == "cutter depth").verdict == "warn"
    # the clearance at the ring's root is what they are cut short for
    assert found.clearances[1] == pytest.approx(0.25 * M, rel=1e-9)


def test_interference_of_cutter_and_ring():
    error = told(inside((0.3, -0.3), teeth=59))
    assert "the cutter of 59 teeth cuts the tips of gear 2 away" in error.message
    assert error.remedy == "a cutter of at most 56 teeth"
    assert solve_pair(inside((0.3, -0.3), teeth=56)).verdict == "warn"
    assert "cutter interference" in {
        check.name
        for check in solve_pair(inside((0.3, -0.3), refuse=False, teeth=59)).checks
        if check.verdict == "fail"
    }


def test_feeding_in_is_a_warning():
    found = solve_pair(inside((0.3, -0.3), teeth=53))
    feed = next(check for check in found.checks if check.name == "cutter feed")
    assert (feed.verdict, feed.margin < 0) == ("warn", True)
    assert "at most 48 teeth" in feed.text


def test_a_usual_cutter_says_nothing():
    checks = {check.name: check for check in solve_pair(inside(teeth=25)).checks}
    assert all(checks[name].verdict == "ok" for name in NAMES)
    plain = PairTask((20, 60), M, kind="internal", strategy="zero")
    assert not {check.name for check in solve_pair(plain).checks} & {*NAMES}


def test_a_shift_that_the_ring_cannot_take():
    assert "its shift x0 = 0.5 and x2 add up to 0.2" in told(inside((0.3, -0.3), teeth=59, shift=0.5)).message
