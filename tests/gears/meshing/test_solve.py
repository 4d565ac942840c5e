"""External pairs from the task to every size, in metres, against the worked cases."""

from dataclasses import replace
from math import cos, degrees, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from gears.involute.cases import case
from gears.meshing.pairs import MM, M, book, given, lengths, plain_everywhere
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.measure.angles import sexagesimal
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.columns import pair_columns
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair, solve_pairs
from tmmcalc.gears.meshing.task import PairsTask, PairTask

NAMES = {"r": "reference", "r_w": "operating", "r_a": "tip", "r_f": "root", "r_b": "base"}


def values(found: MeshPair) -> dict[str, float]:
    """A solved pair by the names and in the units of the cases."""
    line, peaks = found.line, found.peaks
    assert peaks is not None
    named = {
        "alpha_t_deg": degrees(found.angle_t),
        "alpha_tw_rad": found.angle_w,
        "alpha_tw_deg": degrees(found.angle_w),
        "eta": found.stretch,
        "a": found.reference_distance / MM,
        "a_w": found.distance / MM,
        "y": found.modification,
        "delta_y": found.shortening,
        "x_sum": sum(found.shifts),
        "N1N2": line.length / MM,
        "N1A2": line.start / MM,
        "N2A1": (line.length - line.end) / MM,
        "N1L1": found.sizes[0].limit / MM,
        "N2L2": found.sizes[1].limit / MM,
        "g_alpha": (line.end - line.start) / MM,
        "eps_alpha": found.contact_ratio,
        "eps_beta": found.overlap,
        "eps_gamma": found.total,
        "theta1_at_A2": peaks.theta1,
        "theta2_at_A1": peaks.theta2,
        "lambda_at_A2": peaks.pressure_start,
        "lambda_at_P": peaks.pressure_pitch,
        "lambda_at_A1": peaks.pressure_end,
    }
    for i, wheel in enumerate(found.sizes, 1):
        named |= {f"{name}{i}": getattr(wheel, field) / MM for name, field in NAMES.items()}
        named[f"s_a{i}_normal"] = wheel.tip_thickness / MM
    return named


@pytest.mark.parametrize(
    ("name", "task"),
    [
        ("IG-S02", given(14, 27, 0.52, 0.31, 15)),
        ("IG-S04", book()),
        ("IG-S05", given(13, 30, 0.25, 0.15)),
    ],
)
def test_worked_pairs(name, task):
    expected, found = case(name)["expected"], solve_pair(task)
    compared = 0
    for key, value in values(found).items():
        if key in expected:
            assert value == pytest.approx(expected[key], abs=2e-6), key
            compared += 1
    assert compared >= 19
    sign, whole, minutes, seconds = sexagesimal(found.angle_w)
    assert (sign, whole, minutes) == (1, *expected["alpha_tw_dms"][:2])
    assert seconds == pytest.approx(expected["alpha_tw_dms"][2], abs=0.011)


def test_ig_s06_sliding_along_the_line():
    rows = case("IG-S06")["expected"]["rows"]
    table = solve_pair(book()).sliding
    for row in (rows[0], rows[4], rows[-1]):  # A2, P and A1 are among the points
        k = int(np.argmin(np.abs(table.rho1 - row["rho1"] * MM)))
        assert table.rho1[k] == pytest.approx(row["rho1"] * MM, abs=1e-9)
        assert [table.theta1[k], table.theta2[k]] == pytest.approx([row["theta1"], row["theta2"]], abs=2e-6)
        assert table.pressure[k] == pytest.approx(row["lambda"], abs=1e-6)
    for row in rows:  # between them the curves are smooth
        assert np.interp(row["rho1"] * MM, table.rho1, table.theta1) == pytest.approx(row["theta1"], abs=2e-3)


def test_sliding_table_is_dashed_outside_the_contact():
    found = solve_pair(book())
    table, line = found.sliding, found.line
    assert 70 <= len(table.rho1) <= 100
    assert np.all(np.diff(table.rho1) > 0)
    assert 0 < table.rho1[0] < line.start
    assert line.end < table.rho1[-1] < line.length
    assert np.array_equal(table.active, (table.rho1 >= line.begins) & (table.rho1 <= line.ends))
    at_pitch = int(np.argmin(np.abs(table.along)))
    assert abs(table.along[at_pitch]) < 1e-17
    assert max(abs(table.theta1[at_pitch]), abs(table.theta2[at_pitch])) < 1e-14
    assert table.theta1[table.active][0] == pytest.approx(found.peaks.theta1, rel=1e-12)
    assert table.theta2[table.active][-1] == pytest.approx(found.peaks.theta2, rel=1e-12)


def test_ig_s08_undercut_ends_the_involute():
    wheel = solve_pair(given(10, 60, 0.0, 0.0, refuse=False)).sizes[0]
    expected = case("IG-S08")["expected"]
    assert wheel.form == pytest.approx(expected["r_F"] * MM, abs=1e-9)
    assert wheel.limit == pytest.approx(expected["LN"] * MM, abs=1e-9)
    assert wheel.least_shift == pytest.approx(expected["x_min"], abs=1e-6)
    assert wheel.active >= wheel.form


@pytest.mark.parametrize("point", case("IG-S09")["expected"]["points"])
def test_ig_s09_points_of_the_contour(point):
    found = solve_pair(given(14, 17, point["x1"], point["x2"], refuse=False))
    line, (one, two) = found.line, found.sizes
    values = {
        "a_w_over_m": found.distance / M,
        "uc1": point["x1"] - one.least_shift,
        "uc2": point["x2"] - two.least_shift,
        "eps_alpha": found.contact_ratio,
        "s_a1": one.tip_thickness / M,
        "s_a2": two.tip_thickness / M,
        "int1": (line.start - one.limit) / M,
        "int2": (line.length - line.end - two.limit) / M,
    }
    if found.shortened == found.contact_ratio:
        values |= {"theta1_A2": found.peaks.theta1, "theta2_A1": found.peaks.theta2}
    for key, value in values.items():
        assert value == pytest.approx(point[key], abs=2e-6), key


def test_ig_s13_infeasible_pair():
    with pytest.raises(NoSolutionError, match=r"pair z = 14/17: the involute.*-0.634717"):
        solve_pair(given(14, 17, -0.4, -0.4))
    with pytest.raises(NoSolutionError, match="involute"):  # there is nothing to tell about
        solve_pair(given(14, 17, -0.4, -0.4, refuse=False))


@pytest.mark.parametrize("k", [0, 1])
def test_ig_s14_middle_of_the_admissible_interval(k):
    inputs, (low, high) = case("IG-S14")["inputs"], case("IG-S14")["expected"]["intervals"][k]
    asked = inputs["variants"][k]
    limits = QualityLimits(contact_ratio=asked["eps_min"], tip_thickness=asked["s_a_min"])
    found = solve_pair(book(shifts=(None, None), split="middle", limits=limits))
    assert found.shifts[0] == pytest.approx((low[0] + high[0]) / 2, abs=1e-4)
    assert sum(found.shifts) == pytest.approx(inputs["x_sum"], abs=1e-7)
    assert found.distance == 0.085


PAIRS = [
    given(14, 17, 0.6, 0.522),
    book(),
    given(20, 41, 0.0, 0.0, 30),
    given(25, 25, -0.1, 0.3, 8, rack=Rack(radians(25), 1.0, 0.2)),
    given(12, 100, 0.1, -0.1, 45),
]


@pytest.mark.parametrize("task", PAIRS)
def test_identities(task):
    found = solve_pair(task)
    (one, two), m, rack = found.sizes, task.module, task.rack
    assert found.clearances == pytest.approx((rack.clearance * m,) * 2, rel=1e-12)
    assert found.distance - one.tip - two.root == pytest.approx(found.clearances[1], rel=1e-12)
    assert one.operating + two.operating == pytest.approx(found.distance, rel=1e-14)
    assert cos(found.angle_w) * found.distance == pytest.approx(
        cos(found.angle_t) * found.reference_distance, rel=1e-14
    )
    # no backlash: the normal arcs of both fill the pitch circle's pitch
    arcs = sum(row.arc for each in found.measures for row in each.chords if row.name == "operating")
    helix = found.measures[0].chords[1].helix
    assert arcs == pytest.approx(2 * pi * one.operating / one.teeth * cos(helix), rel=1e-12)
    # the contact ratio by the tangents of the tip angles
    tangents = sum(w.teeth * sqrt((w.tip / w.base) ** 2 - 1) for w in (one, two))
    by_tangents = (tangents - (one.teeth + two.teeth) * tan(found.angle_w)) / (2 * pi)
    assert found.contact_ratio == pytest.approx(by_tangents, rel=1e-12)
    assert found.line.length == pytest.approx(found.distance * sin(found.angle_w), rel=1e-14)
    assert found.line.pitch == pytest.approx(one.operating * sin(found.angle_w), rel=1e-14)
    assert one.active == pytest.approx(np.hypot(one.base, max(found.line.start, found.line.begins)), rel=1e-14)
    # statements 1 and 2 are inverse of each other
    back = solve_pair(replace(task, strategy="given_aw", distance=found.distance, shifts=(found.shifts[0], None)))
    assert back.shifts == pytest.approx(found.shifts, abs=1e-13)


@pytest.mark.parametrize("task", PAIRS)
@pytest.mark.parametrize("module", [5e-5, 0.05])
def test_scaling(task, module):
    scale = module / task.module
    sized = {
        "module": module,
        "face_width": None if task.face_width is None else task.face_width * scale,
        "distance": None if task.distance is None else task.distance * scale,
    }
    small, large = lengths(solve_pair(task)), lengths(solve_pair(replace(task, **sized)))
    assert small.keys() == large.keys()
    for key, value in small.items():
        assert large[key] == pytest.approx(scale * value, rel=1e-11, abs=1e-13 * module), key


@pytest.mark.parametrize("task", [*PAIRS, PairTask((14, 17), M), given(14, 17, 0.0, 0.0, refuse=False, name="first")])
def test_round_trip(task):
    found = solve_pair(task)
    plain_everywhere(found)
    record = to_record(Pairs((found,), "", ()))
    back = from_record(Pairs, record).pairs[0]
    assert repr(back) == repr(found)
    assert back.task == task
    assert np.array_equal(back.sliding.rho1, found.sliding.rho1)


@pytest.mark.parametrize("strategy", ["balanced", "equal_sliding", "max_contact_ratio", "max_contact_strength"])
def test_chosen_shifts_are_inside(strategy):
    found = solve_pair(PairTask((14, 29), M, strategy=strategy, helix=radians(10)))
    assert found.broken == ()
    assert found.nearest is None
    assert found.verdict != "fail"
    assert all(x >= wheel.least_shift - 1e-9 for x, wheel in zip(found.shifts, found.sizes, strict=True))
    if strategy == "equal_sliding":
        assert found.peaks.theta1 == pytest.approx(found.peaks.theta2, rel=1e-9)
        assert found.contact_ratio == pytest.approx(1.2, abs=1e-9)


@pytest.mark.slow
def test_checks_alone_tell_whether_shifts_are_inside():
    """Points around the contour, against its own margins."""
    rng = np.random.default_rng(5)
    seen = set()
    for _ in range(16):
        x1, x2 = rng.uniform(-0.6, 1.4, 2)
        tolerated = bool(rng.integers(2))
        limits = QualityLimits(undercut=tolerated, contact_ratio=1.1, tip_thickness=0.2)
        try:
            found = solve_pair(given(14, 22, x1, x2, refuse=False, limits=limits))
        except NoSolutionError:
            continue
        inside = float(margins(contour_task(found.task), x1, x2).least(not tolerated)) >= 0
        assert (not found.broken) == inside
        assert (found.nearest is None) == inside
        seen.add((inside, tolerated))
    assert len(seen) == 4


def test_broken_shifts_are_told_in_words():
    found = solve_pair(given(10, 30, 0.0, 0.0, refuse=False, limits=QualityLimits(undercut=False)))
    assert found.verdict == "fail"
    assert any("undercut of wheel 1" in text for text in found.broken)
    better = solve_pair(replace(found.task, shifts=found.nearest, refuse=True))
    assert better.verdict != "fail"
    assert solve_pair(given(16, 20, 0.0, 0.0)).broken == ()  # tolerated, as given


def test_refusals_name_the_pair_the_reasons_and_the_remedy():
    task = given(14, 17, 1.8, 0.0, name="first stage")
    with pytest.raises(NoSolutionError) as told:
        solve_pair(task)
    text = str(told.value)
    assert text.startswith("pair first stage: z = 14/17: ")
    assert "pointed" in text
    assert "margin" in text
    assert "nearest admissible shifts are x1 = " in text
    x1, x2 = (float(part.split(" = ")[1]) for part in text.split("shifts are ")[1].split(";")[0].split(", "))
    assert solve_pair(replace(task, shifts=(x1, x2))).verdict != "fail"
    assert solve_pair(replace(task, refuse=False)).verdict == "fail"


def test_too_near_axes_are_told_in_millimetres():
    least = 5 * 31 / 2 * cos(radians(20))
    with pytest.raises(NoSolutionError) as told:
        solve_pair(given(14, 17, None, None, strategy="given_aw", distance=0.070))
    text = str(told.value)
    assert "centre distance 70 mm does not exceed" in text
    assert f"{least:.6g} mm" in text
    assert "the nearest admissible centre distance is" in text
    assert told.value.limit == pytest.approx(least * MM, rel=1e-12)
    with pytest.raises(UsageError, match="centre distance is missing"):
        solve_pair(PairTask((14, 17), M, strategy="given_aw"))


@pytest.mark.parametrize("kind", ["external", "internal", "rack"])
def test_a_rack_too_narrow_for_the_usual_rounding_is_told(kind):
    wide = PairTask((30, 0 if kind == "rack" else 90), M, kind=kind, strategy="zero", rack=Rack(radians(25)))
    note = solve_pair(wide).note
    assert "fully rounded by 1.58941 mm, rho* = 0.3179" in note
    assert "usual" not in solve_pair(replace(wide, rack=Rack(radians(20)))).note


def test_wide_axes_name_the_distance():
    with pytest.raises(NoSolutionError, match="centre distance 95 mm: no shifts with the sum"):
        solve_pair(given(14, 17, None, None, strategy="given_aw", distance=0.095))
    with pytest.raises(NoSolutionError, match=r"the nearest have the centre distance [0-9.]+ mm"):
        solve_pair(given(14, 17, 1.6, None, strategy="given_aw", distance=0.086))
    told = solve_pair(given(14, 17, None, None, strategy="given_aw", distance=0.095, refuse=False))
    assert told.shifts[0] == told.shifts[1]
    assert "divided equally" in told.note
    assert told.verdict == "fail"
    with pytest.raises(NoSolutionError, match="leave one of the shifts out"):
        solve_pair(given(14, 17, 0.7, 0.2, strategy="given_aw", distance=0.085))


def test_undercut_is_chosen_only_where_nothing_else_is_left():
    task = PairTask((15, 18), M, strategy="equal_shift")
    found = solve_pair(task)
    assert "undercut" in found.note or "without" in found.note
    assert found.verdict == "warn"
    assert any(check.name == "undercut" and check.verdict == "warn" for check in found.checks)
    with pytest.raises(NoSolutionError):
        solve_pair(replace(task, limits=QualityLimits(undercut=False)))


def test_several_errors_come_at_once():
    good, bad = given(20, 40, 0.0, 0.0), given(14, 17, -0.4, -0.4, name="A")
    with pytest.raises(NoSolutionError) as told:
        solve_pairs(PairsTask((bad, good, replace(bad, name="B"))))
    text = str(told.value)
    assert text.startswith("pairs: 2 of 3 cannot be made")
    assert "A: z = 14/17" in text
    assert "B: z = 14/17" in text
    with pytest.raises(NoSolutionError) as single:
        solve_pairs(PairsTask((good, bad)))
    assert str(single.value).startswith("pair A: z = 14/17")
    assert len(solve_pairs(PairsTask((good, good))).pairs) == 2
    with pytest.raises(UsageError, match="neither a pair nor a train"):
        solve_pairs(PairsTask())


def test_tips_as_asked_rule_everything():
    usual = solve_pair(book())
    cut = solve_pair(book(tips=(usual.sizes[0].tip - 0.5 * MM, None)))
    assert cut.sizes[0].tip == usual.sizes[0].tip - 0.5 * MM
    assert cut.sizes[1].tip == usual.sizes[1].tip
    assert cut.clearances[1] == pytest.approx(usual.clearances[1] + 0.5 * MM, rel=1e-9)
    assert cut.contact_ratio < usual.contact_ratio
    end = sqrt(cut.sizes[0].tip ** 2 - cut.sizes[0].base ** 2)
    assert cut.line.end == pytest.approx(end, rel=1e-13)
    assert next(c.value for c in cut.checks if c.name == "contact ratio") == cut.contact_ratio
    assert cut.measures[0].span_tip == pytest.approx(2 * end, rel=1e-13)
    with pytest.raises(NoSolutionError, match=r"(?s)clearance.*tip diameters by the rule: 86.7796 mm and 101.531 mm"):
        solve_pair(book(tips=(usual.sizes[0].tip + 2 * MM, None)))


def test_tip_within_the_base_circle_is_told():
    task = book(tips=(0.033, None), refuse=False)
    found = solve_pair(task)
    plain_everywhere(found)
    assert found.verdict == "fail"
    assert found.peaks is None
    assert not found.sliding.active.any()
    with pytest.raises(NoSolutionError, match="within its base circle"):
        solve_pair(replace(task, refuse=True))


def test_wheel_cut_away():
    with pytest.raises(NoSolutionError, match="nothing is left of the wheel"):
        solve_pair(given(5, 300, -1.5, 1.0, refuse=False))


def test_columns():
    found = solve_pairs(PairsTask((book(name="a"), given(20, 41, 0.0, 0.0))))
    columns = pair_columns(found)
    assert list(columns) == ["pair", "rho1[m]", "s[m]", "theta1", "theta2", "lambda", "active"]
    assert {len(column) for column in columns.values()} == {sum(len(p.sliding.rho1) for p in found.pairs)}
    assert set(columns["pair"]) == {"a", "z = 20/41"}
    assert set(columns["active"]) == {"yes", "no"}
    assert pair_columns(Pairs((), "", ())) == {}
