"""Ladders lead where closed forms say, and what is met on them is told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.stress import cams, gears, linkage, manipulators, numbering, scales, shipped, synthesis
from tmmcalc.stress.ladders import LADDERS
from tmmcalc.stress.limits import limit_of
from tmmcalc.stress.results import ERROR, FAULT, OK, WARNING, Ladder, Met, Rung
from tmmcalc.stress.run import solve_stress

from .scenes import scene, variants

FEW = "extreme/positions-few"


def climbed(name: str, ladder: str, *overrides: str, stage: str | None = None) -> Ladder:
    (found,) = solve_stress(variants(name, *overrides), [ladder], stage).ladders
    return found


@pytest.mark.slow
def test_dead_point_of_a_crank_slider_is_a_crank_as_long_as_the_rod(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(linkage, "DISTANCES", (1.0, 1e-2, 1e-6, 1e-10, 0.0))
    ladder = climbed(FEW, "dead-point", stage="kinematics")
    assert "length to A of link 1 to 4 times" in ladder.title
    first, *_, last = ladder.rungs
    assert first.condition == pytest.approx(1 / (1 - 1 / 16) ** 0.5, rel=1e-12)
    assert last.met[-1].status == ERROR
    assert (last.met[-1].code, "dead point at angle_1" in last.met[-1].message) == (3, True)
    for rung in ladder.rungs[1:-1]:
        # the regularity is sqrt(1 - (r/l)^2), with 1 - r/l = 0.75 of the part of the way that is left
        part = 0.75 * rung.size
        assert rung.condition == pytest.approx(1 / (2 * part - part * part) ** 0.5, rel=max(1e-9, 1e-11 / part))
        (met,) = (met for met in rung.met if met.stage == "kinematics")
        assert met.error is not None
        assert met.error < 1e-14 * (rung.condition or 0.0) ** 2


@sparing("name", ["four-bar", "slotted-link"], every=2)
def test_toward_a_dead_point_the_stage_tells_as_much_as_is_lost(name: str) -> None:
    """The twin differs in the last digits of its lengths, which the error estimate takes as exact."""
    track = [(rung, met) for rung, met in climbed(name, "dead-point").track("kinematics") if met.error is not None]
    assert len(track) == 8
    for rung, met in track:
        assert met.error is not None
        assert met.covered is not None
        assert met.covered >= met.error, rung.setting
    assert all(met.last_digit is not None for _, met in track if (met.error or 0.0) > 1e-13)


@pytest.mark.slow
def test_cusp_of_a_cam_is_the_least_radius_of_its_pitch_curve(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cams, "LEFT", (1.0, 1e-6, -1e-3))
    ladder = climbed("extreme/cusp-near", "cusp", "cam.roller_radius='10 mm'", stage="cam_profile")
    assert "to 23.9875515 mm" in ladder.title
    profile = dict(ladder.track("cam_profile"))
    assert [met.status for met in profile.values()][-1] == ERROR
    assert all(met.code == 0 for met in list(profile.values())[:-1])


def test_cusp_under_a_flat_face(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cams, "LEFT", (1.0, 1e-6, -1e-3))
    ladder = climbed("cam-flat", "cusp", stage="cam_profile")
    assert "distance of the face to 39.64" in ladder.title
    *others, (_, last) = ladder.track("cam_profile")
    assert last.code == 3
    assert all(met.code == 0 for _, met in others)


def test_positions_do_not_change_what_stands_at_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numbering, "POSITIONS", (12, 360, 3600))
    ladder = climbed(FEW, "positions")
    assert [rung.condition for rung in ladder.rungs] == [4, 12, 360, 3600]
    errors = [met.error for rung in ladder.rungs for met in rung.met if met.error is not None]
    assert len(errors) > 6
    assert max(errors) < 1e-12


@pytest.mark.parametrize("name", ["four-bar", "slotted-link"])
def test_position_0_may_be_anywhere(name: str) -> None:
    ladder = climbed(name, "start")
    assert len(ladder.rungs) == 12
    for _, met in ladder.track("kinematics"):
        assert met.error is not None
        assert met.error < 1e-13


@pytest.mark.parametrize("ladder", ["positions", "start", "direction", "scale"])
def test_wanted_paths_stay_as_far(monkeypatch: pytest.MonkeyPatch, ladder: str) -> None:
    monkeypatch.setattr(numbering, "POSITIONS", (12, 36))
    moved = 'paths=[{point="P", through=[[0.02, 0.02], [0.02, 0.03], [0.04, 0.01]], turn=0.1, shift=[0.001, 0.002]}]'
    track = climbed("wanted-path", ladder, 'mechanism.input.speed="10 rad/s"', moved).track("paths")
    errors = [met.error for _, met in track if met.error is not None]
    assert len(errors) > (ladder == "positions")
    assert max(errors) < 1e-13


def test_scale_from_micrometres_to_kilometres() -> None:
    ladder = climbed("press", "scale", stage="forces")
    assert {rung.size for rung in ladder.rungs} >= {1e-6, 1e-3, 1.0, 1e3}
    assert not list(ladder.degraded())
    assert all(met.error is not None and met.error < 1e-13 for _, met in ladder.track("forces"))


@pytest.mark.slow
@sparing("ladder", ["inertia", "slip"], every=2)
def test_ladders_of_a_machine(ladder: str) -> None:
    found = climbed("extreme/slip", ladder, stage="motion")
    sizes = [rung.size for rung in found.rungs]
    assert max(sizes) / min(sizes) >= 1e5
    assert {met.status for _, met in found.track("motion")} <= {OK, WARNING}


@pytest.mark.slow
def test_stiffness_and_lag(monkeypatch: pytest.MonkeyPatch) -> None:
    from tmmcalc.stress import machine

    monkeypatch.setattr(machine, "STIFFNESSES", [1e2, 1e9])
    monkeypatch.setattr(machine, "LAGS", [1e-1, 1e-9])
    shaft = climbed("extreme/shaft-stiffness", "stiffness", stage="transient")
    assert [rung.condition for rung in shaft.rungs] == [1.0, pytest.approx(10**3.5)]
    assert len(shaft.track("transient")) == 2
    lag = climbed("extreme/lag-tiny", "lag", stage="motion")
    assert [rung.condition for rung in lag.rungs] == [pytest.approx(8.0), pytest.approx(8e8)]
    assert all(met.error is not None and met.error < 1e-9 for _, met in lag.track("motion"))


def test_what_a_scene_has_not_is_left_out_with_the_reason() -> None:
    result = solve_stress(variants("rotor"))
    assert [ladder.name for ladder in result.ladders] == ["scale"]
    reasons = dict(result.without)
    assert len(reasons) == 17
    assert reasons["dead-point"] == "the scene has no linkage"
    with pytest.raises(UsageError, match="no linkage"):
        solve_stress(variants("rotor"), ["dead-point"])
    with pytest.raises(UsageError, match="no ladder is called"):
        solve_stress(variants("rotor"), ["nothing"])
    with pytest.raises(UsageError, match="a crank without a speed"):
        solve_stress(variants("wanted-path"), ["direction"])
    with pytest.raises(UsageError, match="are counted from position 0"):
        solve_stress(variants("wanted-path", "paths[0].at=[0, 1, 2, 3, 4, 5]"), ["start"])


def failing(kind: Callable[[], Exception]) -> Callable[..., Any]:
    def run(*args: object, **more: object) -> Any:
        raise kind()

    return run


def test_a_fault_of_the_program_is_met_and_not_thrown(monkeypatch: pytest.MonkeyPatch) -> None:
    source = variants(FEW)
    held = scene(FEW)
    monkeypatch.setattr("tmmcalc.stress.run.run", lambda *_, **__: held.base)
    monkeypatch.setattr("tmmcalc.stress.scene.run", failing(lambda: ValueError("not a number")))
    result = solve_stress(source, ["direction"])
    (name, _, met), *_ = result.faults
    assert (name, met.status, met.code, met.message) == ("direction", FAULT, 1, "ValueError: not a number")


def test_where_accuracy_degrades_and_whether_it_was_told() -> None:
    def rung(size: float, error: float, estimate: float, status: str = OK) -> Rung:
        return Rung(f"x {size:g}", size, size, (Met("forces", status, error=error, estimate=estimate),))

    plain = Ladder("a", "a", "b", "c", (rung(1, 1e-12, 1e-11), rung(2, 1e-8, 1e-9), rung(3, 1e-5, 1e-4)))
    assert [(d.limit, d.rung.size, d.told) for d in plain.degraded()] == [(1e-9, 2, False), (1e-6, 3, True)]
    warned = replace(plain, rungs=(rung(2, 1e-8, 1e-9, WARNING),))
    assert [d.told for d in warned.degraded()] == [True]


def errors(ladder: Ladder, stage: str) -> list[float]:
    """Observed errors of a stage, where there are any."""
    return [met.error for _, met in ladder.track(stage) if met.error is not None]


@pytest.mark.slow
def test_a_forearm_that_just_reaches(monkeypatch: pytest.MonkeyPatch) -> None:
    """The farthest point of the path is 1.2449899598 m from the shoulder: what the upper arm of 0.9 m leaves."""
    monkeypatch.setattr(manipulators, "DISTANCES", (1.0, 1e-4, 1e-8, 0.0))
    ladder = climbed("manipulator-angular", "singular")
    farthest = (1.1**2 + 0.5**2 + 0.3**2) ** 0.5
    assert float(ladder.title.split("to ")[-1].split(" ")[0]) == pytest.approx((farthest - 0.9) / 0.8, rel=1e-8)
    *others, last = ladder.rungs
    assert last.met[-1].code == 3
    conditions = [rung.condition or 0.0 for rung in others]
    # sin^2 of the elbow falls as the part of the way that is left
    assert conditions[2] == pytest.approx(100 * conditions[1], rel=1e-3)
    assert max(errors(ladder, "manipulator")) < 1e-6


def test_a_path_led_to_the_shoulder(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manipulators, "DISTANCES", (1.0, 1e-3, 0.0))
    _, near, last = climbed("manipulator", "singular").rungs
    assert near.met[0].status == WARNING
    assert "passes the shoulder" in last.met[0].message


@pytest.mark.slow
def test_gears_keep_their_digits_where_their_shapes_do(monkeypatch: pytest.MonkeyPatch) -> None:
    few = climbed("pair-helical", "teeth", stage="pair")
    assert [rung.setting for rung in few.rungs][:2] == ["z = 3/17", "z = 4/17"]
    assert max(rung.condition or 0.0 for rung in few.rungs) == 3400
    assert max(errors(few, "pair")) < 1e-13
    monkeypatch.setattr(gears, "LEFT", (1.0, 1e-6, -1e-3))
    border = climbed("pair", "shift", stage="blocking")
    assert [met.code for _, met in border.track("pair")] == [0, 0, 3]
    assert max(errors(border, "pair")) < 1e-13


@pytest.mark.slow
def test_a_mesh_that_closes_loses_digits_as_its_angle_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """inv(alpha) = Q: what a rounding of the shifts is to Q, which goes as the part of the way left."""
    monkeypatch.setattr(gears, "LEFT", (1.0, 1e-4, 1e-8, 1e-12, -1e-3))
    ladder = climbed("pair-helical", "mesh-angle", stage="pair")
    _, *lost = errors(ladder, "pair")
    assert all(error < 1e-15 / left for error, left in zip(lost, (1e-4, 1e-8, 1e-12), strict=True))
    assert lost[-1] > 1e3 * lost[1] > 1e6 * lost[0] > 0
    (beyond,) = ladder.rungs[-1].met
    assert "has to exceed" in beyond.message


def test_a_train_with_as_many_times_the_teeth_is_the_same() -> None:
    ladder = climbed("gears-circulating", "teeth")
    assert ladder.rungs[-1].condition == 60_000
    assert max(errors(ladder, "gearing")) < 1e-14


def test_torques_of_all_sizes() -> None:
    ladder = climbed("gears-pairs", "torque", stage="criteria")
    ends = [met.code for _, met in ladder.track("criteria")]
    assert ends == [0] * 5 + [3] * 2


def test_a_time_ratio_of_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """r/L is the sine of half the swing, pi/2 (K - 1)/(K + 1): a rounding of K is 1/(K - 1) of that."""
    monkeypatch.setattr(synthesis, "DISTANCES", (1.0, 1e-2, 1e-4, 0.0))
    ladder = climbed("synth-slotted-link", "time-ratio")
    for rung, met in ladder.track("synthesis")[:3]:
        assert met.error is not None
        assert rung.condition is not None
        assert met.error < 1e-15 * rung.condition
    assert ladder.rungs[-1].met[-1].code == 2


@pytest.mark.slow
def test_a_range_that_is_a_point(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(synthesis, "NARROWER", (1.0,))
    (rung,) = climbed("synth-function", "range", "synthesis.function.points=3").rungs
    assert rung.condition == 1.0
    assert rung.met[0].error is not None
    assert rung.met[0].error < 1e-11


@pytest.mark.slow
def test_a_stem_over_the_axis_is_pressed_aside() -> None:
    """tan(theta) = S'/S at the place of the largest: at a start distance of nothing it has no bound."""
    ladder = climbed("cam", "pressure", stage="cam_pressure")
    conditions = [rung.condition for rung in ladder.rungs]
    assert conditions == sorted(conditions, key=lambda each: each or 0.0)
    assert (conditions[-1] or 0.0) > 10
    assert all(error < 1e-12 for error in errors(ladder, "cam_pressure"))


@pytest.mark.slow
def test_rows_and_the_sense_of_a_cam(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numbering, "CAM_STEPS", (2, 12, 3600))
    rows = climbed("cam-groove", "positions")
    assert [rung.size for rung in rows.rungs] == [2, 12, 3600]
    assert not list(rows.degraded())
    for name in ("cam-groove", "cam-oscillating"):
        (mirrored,) = climbed(name, "direction").rungs
        assert {met.status for met in mirrored.met} <= {OK, WARNING}
        assert all((met.error or 0.0) < 1e-14 for met in mirrored.met)


def test_long_scenes_leave_rungs_out_unless_the_ladder_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.stress.run.LADDERS", {"start": LADDERS["start"]})
    (whole,) = solve_stress(variants("four-bar")).ladders
    monkeypatch.setattr("tmmcalc.stress.run.LONG", ("kinematics",))
    (some,) = solve_stress(variants("four-bar")).ladders
    settings = [rung.setting for rung in whole.rungs]
    assert [rung.setting for rung in some.rungs] == [*settings[::4], settings[-1]]
    assert len(climbed("four-bar", "start").rungs) == len(settings) == 12


def test_shipped_scenes_say_what_of_their_end_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shipped, "scenes", lambda: ["extreme/positions-few", "extreme/dead-point"])
    few, dead = shipped.solve_shipped().ladders[0].rungs
    assert (few.answer, dead.answer) == ("2 numbers as known", "exit 3 as known")
    monkeypatch.setattr(shipped, "disagreements", lambda *_: iter(["another end"]))
    result = shipped.solve_shipped()
    assert {rung.answer for rung in result.ladders[0].rungs} == {"missed"}
    assert len(result.faults) == 2


def test_losses_have_their_worst_rung() -> None:
    def rung(size: float, error: float | None) -> Rung:
        return Rung(f"x {size:g}", size, size, (Met("forces", OK, error=error), Met("power", OK)))

    ladder = Ladder("a", "a", "b", "c", (rung(1, 1e-15), rung(2, 3e-7), rung(3, 1e-9), rung(4, None)))
    (loss,) = ladder.losses()
    assert (loss.stage, loss.ordinary, loss.rung.size, loss.met.error) == ("forces", 1e-15, 2, 3e-7)


@pytest.mark.parametrize(("good", "bad"), [(1.0, 3.0), (1.0, 0.1), (2.0, 1.0)])
@pytest.mark.parametrize("power", [0.5, 1.0, 0.25])
def test_the_limit_is_found_whatever_the_regularity_does(good: float, bad: float, power: float) -> None:
    """The program's goes as the root of the way; where it does not, halving still comes there."""
    limit, runs = good + 0.7310585786300049 * (bad - good), []

    def regular(factor: float) -> float | None:
        runs.append(factor)
        way = (limit - factor) / (limit - good)
        return way**power if way > 0 else None

    assert limit_of(regular, good, bad) == pytest.approx(limit, rel=1e-9)
    assert len(runs) < (20 if power == 0.5 else 100)


@pytest.mark.slow
def test_a_tipper_whose_start_is_a_dead_point_all_but_a_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the samples of its output those beyond the edge are none, by rounding."""
    monkeypatch.setattr(linkage, "DISTANCES", (1.0, 1e-10, 0.0))
    ladder = climbed("tipper", "dead-point")
    assert {met.status for rung in ladder.rungs[:2] for met in rung.met} <= {OK, WARNING}
    assert [met.code for met in ladder.rungs[-1].met][-1] == 3


def test_a_driven_length_has_no_radian(monkeypatch: pytest.MonkeyPatch) -> None:
    """A slope over metres is no number of the size of its function: what resolves it must not depend on the unit."""
    monkeypatch.setattr(scales, "SIZES", (1.0, 1e-6, 1e4))
    ladder = climbed("hydraulic-lift", "scale", stage="reduction")
    assert len(errors(ladder, "reduction")) == 3
    assert max(errors(ladder, "reduction")) < 1e-13
