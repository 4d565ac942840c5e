"""Ladders lead where closed forms say, and what is met on them is told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from tmmcalc.errors import UsageError
from tmmcalc.stress import cams, linkage
from tmmcalc.stress.results import ERROR, FAULT, OK, WARNING, Ladder, Met, Rung
from tmmcalc.stress.run import solve_stress

from .scenes import scene, variants

FEW = "extreme/positions-few"


def climbed(name: str, ladder: str, *overrides: str, stage: str | None = None) -> Ladder:
    (found,) = solve_stress(variants(name, *overrides), [ladder], stage).ladders
    return found


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
    monkeypatch.setattr(linkage, "POSITIONS", (12, 360, 3600))
    ladder = climbed(FEW, "positions")
    assert [rung.condition for rung in ladder.rungs] == [12, 360, 3600]
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


def test_scale_from_micrometres_to_kilometres() -> None:
    ladder = climbed("press", "scale", stage="forces")
    assert {rung.size for rung in ladder.rungs} >= {1e-6, 1e-3, 1.0, 1e3}
    assert not list(ladder.degraded())
    assert all(met.error is not None and met.error < 1e-13 for _, met in ladder.track("forces"))


@pytest.mark.parametrize("ladder", ["inertia", "slip"])
def test_ladders_of_a_machine(ladder: str) -> None:
    found = climbed("extreme/slip", ladder, stage="motion")
    sizes = [rung.size for rung in found.rungs]
    assert max(sizes) / min(sizes) >= 1e5
    assert {met.status for _, met in found.track("motion")} <= {OK, WARNING}


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
    assert len(reasons) == 9
    assert reasons["dead-point"] == "the scene has no linkage"
    with pytest.raises(UsageError, match="no linkage"):
        solve_stress(variants("rotor"), ["dead-point"])
    with pytest.raises(UsageError, match="no ladder is called"):
        solve_stress(variants("rotor"), ["nothing"])


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
