"""Unequal dwells and two sizes of rollers: the cams turned through a whole turn against discs, by brute force."""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import tmmcalc
from tmmcalc.cams.files.indexing import chain_of, nc_table, outlines
from tmmcalc.cams.indexing import Indexing, solve_indexing
from tmmcalc.cams.indexing.laws import step_law
from tmmcalc.cams.indexing.outline import outline
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.errors import NoSolutionError, SpecError
from tmmcalc.project import templates

FILE = templates.folder() / "cam-lantern-unequal.toml"
GIVEN = IndexingTask(
    law=step_law("shun"),
    rollers=6,
    step=radians(90),
    wheel=0.05,
    ratio=2.6,
    roller=0.012,
    second_roller=0.009,
    dwells=(radians(130), radians(50)),
)
CHORD = 1e-7


def profiles(task: IndexingTask, found: Indexing) -> tuple[np.ndarray, np.ndarray]:
    """Working profiles of both cams in the axes of the shaft, where the first lobe begins its step."""
    first = outline("", chain_of(task, found), CHORD).polygon
    second = outline("", chain_of(task, found, of_second=True), CHORD).polygon
    return first, second * np.exp(-1j * (task.step + task.rests[0]))


def wheel_turn(task: IndexingTask, phase: float) -> float:
    """Two steps a turn, written out: a step, a dwell, a step, a dwell."""
    s, beta_m = task.law.law, 2 * pi / task.rollers
    starts = 0.0, task.step + task.rests[0]
    done = [min(max((phase - start) / task.step, 0.0), 1.0) for start in starts]
    return beta_m * sum(float(s.at(np.array([k]))[0, 0]) for k in done)


def distances(profile: np.ndarray, centre: complex) -> float:
    """Distance of a point from a closed polygon, negative inside."""
    run = np.roll(profile, -1) - profile
    along = np.clip(((centre - profile) * run.conj()).real / np.abs(run) ** 2, 0, 1)
    least = float(np.abs(profile + along * run - centre).min())
    turned = np.angle((np.roll(profile, -1) - centre) / (profile - centre)).sum()
    return -least if abs(turned) > pi else least


def gaps(task: IndexingTask, found: Indexing, both: tuple[np.ndarray, np.ndarray], phase: float, beta: float) -> list:
    """What is between the rollers of each row and its cam, the least first; the wheel turns clockwise by beta."""
    a, half, result = found.centres, pi / task.rollers, []
    for profile, start, radius in zip(both, (half, -half), (found.roller, found.second.roller), strict=True):
        thetas = start + beta + 4 * half * np.arange(task.rollers // 2)
        shape = profile * np.exp(1j * phase)
        centres = a - task.wheel * np.exp(-1j * thetas)
        near = [c for c in centres if abs(c) < np.abs(profile).max() + radius + 1e-3]
        result.append(sorted(distances(shape, complex(c)) - radius for c in near))
    return result


PHASES = np.radians([0, 7, 22, 45, 61, 66, 75, 88, 95, 150, 215, 222, 240, 265, 283, 300, 309, 320, 350])


@pytest.mark.parametrize("dwells", [(130, 50), (50, 130), (90, 90)])
def test_every_roller_touches_or_is_clear_over_a_turn(dwells: tuple[float, float]) -> None:
    """No disc enters its cam, and on each side one holds the wheel: turned either way it would enter."""
    task = replace(GIVEN, dwells=(radians(dwells[0]), radians(dwells[1])))
    found = solve_indexing(task)
    both = profiles(task, found)
    for phase in PHASES:
        beta = wheel_turn(task, float(phase))
        here = gaps(task, found, both, float(phase), beta)
        every = [gap for row in here for gap in row]
        assert min(every) > -1e-6, np.degrees(phase)
        assert sum(abs(gap) < 1e-6 for gap in every) >= 2, np.degrees(phase)
        for turn in (-2e-3, 2e-3):
            assert min(g for row in gaps(task, found, both, float(phase), beta + turn) for g in row) < -1e-6


def test_the_wheel_turns_as_the_law_asks_by_contact_alone() -> None:
    """The angle at which a disc of either row comes to touch its cam, sought from profiles and radii alone."""
    found = solve_indexing(GIVEN)
    both = profiles(GIVEN, found)
    for phase in np.radians([12, 30, 52, 232, 250, 272]):
        wanted = wheel_turn(GIVEN, float(phase))

        def least(beta: float, phase: float = float(phase)) -> float:
            return min(gap for row in gaps(GIVEN, found, both, phase, beta) for gap in row)

        free = wanted  # between the flanks there is no more room than rounding
        low = brentq(lambda b: least(b) + 2e-6, free - 0.02, free)
        high = brentq(lambda b: least(b) + 2e-6, free, free + 0.02)
        assert (low + high) / 2 == pytest.approx(wanted, abs=3e-4)
        assert high - low < 1e-3


@pytest.mark.slow
def test_profiles_are_envelopes_of_the_rollers() -> None:
    """Discs carried round in the axes of either cam leave its profile: the nearest any of them comes to its points."""
    found = solve_indexing(GIVEN)
    first, second = profiles(GIVEN, found)
    half = pi / GIVEN.rollers
    for profile, start, radius in ((first, half, 0.012), (second, -half, 0.009)):
        tracks = []
        for phase in np.linspace(0, 2 * pi, 4001):
            thetas = start + wheel_turn(GIVEN, float(phase)) + 4 * half * np.arange(-1, 2)
            tracks.append((found.centres - GIVEN.wheel * np.exp(-1j * thetas)) * np.exp(-1j * phase))
        centres = np.concatenate(tracks)
        for point in profile[:: max(len(profile) // 60, 1)]:
            assert np.abs(centres - point).min() == pytest.approx(radius, abs=2e-6)


def test_equal_rollers_make_one_cam_that_is_turned_over() -> None:
    task = replace(GIVEN, second_roller=None)
    found = solve_indexing(task)
    assert found.second.turned_over
    first = outline("", chain_of(task, found), CHORD).polygon
    second = outline("", chain_of(task, found, of_second=True), CHORD).polygon
    over = np.conj(first) * np.exp(-1j * task.step)  # mirrored in the axis of the lobe
    for point in over[::200]:
        assert abs(distances(second, complex(point))) < 1e-6
    assert not solve_indexing(GIVEN).second.turned_over


def test_equal_dwells_written_out_change_nothing() -> None:
    plain = replace(GIVEN, dwells=None, second_roller=None)
    same = solve_indexing(replace(plain, dwells=(pi / 2, pi / 2)))
    alike = solve_indexing(plain)
    assert alike.second is None
    a, b = (outline("", chain_of(*each), CHORD).polygon for each in ((plain, alike), (same.dwells and plain, same)))
    assert np.abs(a - b).max() < 1e-15
    assert same.cam.handover == alike.cam.handover
    assert same.second.lag == pytest.approx(pi)


def test_a_dwell_below_the_recommended_is_warned_of() -> None:
    short = solve_indexing(replace(GIVEN, dwells=(radians(150), radians(30))))
    assert any("2 delta_0" in note for note in short.notes)
    assert not any("2 delta_0" in note for note in solve_indexing(GIVEN).notes)


@pytest.mark.parametrize(("rollers", "step", "ratio"), [(6, 90, 2.6), (6, 150, 2.2), (10, 120, 1.8)])
def test_even_next_to_no_dwell_the_lobe_strikes_no_roller(rollers: int, step: float, ratio: float) -> None:
    """What the lobe has left, or has not come to, stays clear of it: no such limit of a dwell is needed."""
    rests = radians(0.5), 2 * pi - 2 * radians(step) - radians(0.5)
    task = replace(
        GIVEN, rollers=rollers, step=radians(step), ratio=ratio, dwells=rests, roller=0.005, second_roller=0.004
    )
    found = solve_indexing(task)
    both = profiles(task, found)
    for phase in np.linspace(0, 2 * pi, 37):
        here = gaps(task, found, both, float(phase), wheel_turn(task, float(phase)))
        assert min(gap for row in here for gap in row) > -1e-6


def test_limits_hold_for_either_row() -> None:
    with pytest.raises(NoSolutionError, match="a roller of 45 mm"):
        solve_indexing(replace(GIVEN, second_roller=0.045))
    thick = solve_indexing(replace(GIVEN, second_roller=0.012, roller=0.009))
    assert thick.wheel_room == pytest.approx(thick.centres - thick.cam.working_tip)
    assert thick.second.nearest == pytest.approx(0.13 - 0.05 - 0.012)


def test_files_have_both_cams() -> None:
    found = solve_indexing(GIVEN)
    names = [each.name for each in outlines(GIVEN, found)]
    assert names[:4] == ["pitch curve", "working profile", "pitch curve 2", "working profile 2"]
    rows = nc_table(GIVEN, found).decode().splitlines()
    assert rows[0].startswith("cam,part,")
    assert {row.partition(",")[0] for row in rows[1:]} == {"1", "2"}


def test_ready_spec() -> None:
    found = tmmcalc.solve_indexing(tmmcalc.load_spec(FILE))
    assert np.degrees(found.dwells) == pytest.approx([140, 60])
    assert np.degrees(found.second.lag) == pytest.approx(220)
    assert (found.roller, found.second.roller) == (0.0085, 0.007)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (("140 deg", "130 deg"), "dwells of 190 deg are 350 deg, not a turn"),
        (('"8.5 mm", "7 mm"', '"8.5 mm", "70 mm"'), "a roller of 70 mm on a wheel of 60 mm"),
        (('shaft_radius = "18 mm"', 'roller_radius = "8 mm"'), "roller_radii together with roller_radius"),
        (('["140 deg", "60 deg"]', '["200 deg"]'), "is not a list of 2 values"),
    ],
)
def test_faults(tmp_path: Path, change: tuple[str, str], told: str) -> None:
    (tmp_path / "bad.toml").write_text(FILE.read_text().replace(*change))
    with pytest.raises(SpecError) as error:
        tmmcalc.load_spec(tmp_path / "bad.toml")
    assert told in str(error.value)
