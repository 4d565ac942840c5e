"""Studies of tables and raster beside exact extremes: forces, power, balance, pressure angle, forces of cams, tips."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from sparing import sparing

from tmmcalc import load_spec
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.cams.accuracy.sides import beside
from tmmcalc.core.plane import Real
from tmmcalc.core.studies.sampled import COUNTS, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.linkage.accuracy import forces
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.pipeline.runner import run
from tmmcalc.rooms import STAGES

from .scenes import CONFIGS, ONCE, errors_in, errors_of, series_of, studies_of


def test_the_largest_is_found_apart_from_the_place_that_a_method_names() -> None:
    """Two crests and a jump, of which the heights are known; the method names the lower crest, or the right one."""

    def crests(x: Real) -> Real:
        smooth = np.exp(-((x - 2) ** 2)) + 1.5 * np.exp(-4 * (x - 5) ** 2)
        return np.stack((smooth, np.where(x < np.longdouble(1) / 3, x, 0.0)))

    mended = summit(crests, 6.0, [2.0, 0.1])
    assert mended.values[0] == pytest.approx(1.5 + np.exp(-9.0), rel=1e-7)
    assert mended.values[1] == pytest.approx(1 / 3, rel=1e-15), "up to the jump"
    assert mended.short == 0
    assert summit(crests, 6.0, [5.0, 0.333]).values[0] == pytest.approx(float(mended.values[0]), rel=1e-17)


def test_a_crest_between_all_nodes_is_told_in_the_error_of_the_reference() -> None:
    def needle(x: Real) -> Real:
        return (1 + 0.25 * np.exp(-(((x - 1.0007) / 1e-6) ** 2)))[None]

    assert summit(needle, 6.0, [0.5]).short == 0, "nobody knows of it"
    found = summit(needle, 6.0, [1.0007])
    assert float(found.values[0]) == pytest.approx(1.25)
    assert found.short == pytest.approx(0.2)


@pytest.mark.slow
def test_a_stage_that_misses_its_maximum_is_told() -> None:
    """The places of the stage are moved; its own error tells, the tables are judged as before."""
    spec = load_spec(CONFIGS / "engine-compressor.toml")
    ran = run(spec, target="forces").results
    good = studies_of("engine-compressor", "forces")["largest reactions"]
    found: Forces = ran["forces"]
    moved = replace(found, pairs=[replace(p, force=replace(p.force, x=0.3 * found.theta[-1])) for p in found.pairs])
    scene = Scene(STAGES["forces"].inputs(spec), {**ran, "forces": moved}, ONCE)
    (study,) = (study for study in forces.studies(scene) if study.quantity == "largest reactions")
    assert study.reference.error < 1e-18
    assert errors_of(study, "table") == pytest.approx(errors_of(good, "table"), rel=1e-12)
    assert max(errors_of(study, "extremes")) < 1e-13


@sparing("name", ["shaper", "press"], every=2)
def test_passes_of_friction_fall_by_the_loop_gain(name: str) -> None:
    found = [study for quantity, study in studies_of(name, "forces").items() if quantity.startswith("friction")]
    assert found
    for study in found:
        assert study.reference.error < 1e-12
        assert max(errors_of(study, "Newton")) < 1e-12
        passes = series_of(study, "passes")
        errors = errors_in(passes)[:4]  # of 1, 2, 3 and 4 passes
        assert all(later < max(former / 2, 1e-13) for former, later in pairwise(errors)), "the friction is small"
        assert passes.order is None


@sparing("name", ["shaper", "press", "engine-compressor"], every=3)
def test_largest_reactions_off_a_table(name: str) -> None:
    study = studies_of(name, "forces")["largest reactions"]
    assert max(errors_of(study, "extremes")) < 1e-13
    table = errors_of(study, "table")
    if name == "engine-compressor":
        assert _slope(table, 0) == pytest.approx(2.0, abs=0.25)
    if name == "press":
        assert _slope(table, 5) == pytest.approx(1.0, abs=0.1), "the load jumps between positions"
    if name == "shaper":
        assert max(table[:3]) < 1e-14 < 1e-3 < min(table[3:]), "the largest stands on a position of 12 by chance"
        assert series_of(study, "table").cheapest(1e-3) is None


def _slope(table: list[float], first: int) -> float:
    """Of the errors over the step, from a number of positions to the last one."""
    return float(np.log(table[first] / table[-1]) / np.log(COUNTS[-1] / COUNTS[first]))


def test_peaks_of_power_off_a_table() -> None:
    (study,) = studies_of("shaper", "power").values()
    assert max(errors_of(study, "extremes")) < 1e-13
    table = errors_of(study, "table")
    assert _slope(table, 3) == pytest.approx(1.0, abs=0.1), "the load jumps between positions"


CRANK = ("mechanism.links[id=1].mass=2", "mechanism.links[id=1].inertia=0.1")  # and no other mass


def test_a_linkage_that_does_not_shake_has_nothing_to_balance() -> None:
    balanced = (*CRANK, "mechanism.links[id=1].center=[0, 0]")
    assert not studies_of("four-bar", "balance", *balanced)
    assert not studies_of("four-bar", "reduction", *balanced), "J is constant, and nothing works"


def test_a_crank_alone_shakes_with_a_force_that_turns_with_it() -> None:
    """The hodograph in the crank frame is a point: every number of positions gives it."""
    for study in studies_of("four-bar", "balance", *CRANK, "mechanism.links[id=1].center=[0.05, 0]").values():
        assert all(max(errors_in(series)) < 1e-14 for series in study.series), study.quantity
        assert study.reference.error < 1e-14


def test_balance_by_positions() -> None:
    mean, circle = studies_of("shaper", "balance").values()
    assert mean.reference.error < 1e-18
    assert max(errors_of(mean, "series")) < 1e-14
    errors = errors_of(mean, "mean of n")
    # spectral: the digits grow with the positions, 6 to 36, and end in rounding
    digits = -np.log10(errors[:6])
    assert np.all(np.diff(digits) > 0)
    assert digits[5] > 5 * digits[0]
    assert errors[-1] < 1e-14
    assert series_of(mean, "mean of n").order is None
    assert max(errors_of(circle, "circle around the curve")) < 1e-14
    around = errors_of(circle, "circle around n")
    assert around[-1] < 1e-2 * around[0]


@pytest.mark.parametrize("name", ["cam-translating", "cam-oscillating"])
def test_largest_pressure_angle(name: str) -> None:
    (study,) = studies_of(name, "cam_pressure").values()
    assert max(errors_of(study, "extremes")) < 1e-14
    table = errors_of(study, "table")
    assert table[-1] < 1e-2 * table[0]


def test_no_pressure_angle_of_a_flat_face() -> None:
    found = solve_accuracy(load_spec(CONFIGS / "cam-flat.toml"), "cam_pressure", ONCE)
    assert (found.studies, found.settled) == ((), ("cam_pressure",))


def test_pressure_angle_beside_a_jump_of_the_speed() -> None:
    """A linear law: the largest stands at an end of the rise, beyond which there is nothing to be found."""
    for name, overrides in (("extreme/law-jump", ()), ("cam-translating", ('cam.rise_law="linear"',))):
        (study,) = studies_of(name, "cam_pressure", *overrides).values()
        assert max(errors_of(study, "extremes")) < 1e-14, name


def test_sides_of_the_beginning_of_the_turn() -> None:
    """The end of the turn is the last piece's, its beginning the first one's, from wherever they are asked for."""
    program = STAGES["cam_law"].inputs(load_spec(CONFIGS / "cam-translating.toml")).program
    turn = float(program.edges[-1])
    for phi in (0.0, turn, -1e-12, turn + 1e-10):
        (before, last), (behind, first) = beside(program, np.array([phi]))
        assert (before[0], last[0]) == (turn, len(program.edges) - 2)
        assert (behind[0], first[0]) == (0.0, 0)


@sparing("name", ["cam-translating", "cam-oscillating", "cam-groove", "cam-flat"], every=4)
def test_largest_forces_of_a_cam(name: str) -> None:
    (study,) = studies_of(name, "cam_forces").values()
    assert max(errors_of(study, "extremes")) < 1e-13
    table = errors_of(study, "table")
    assert table[-1] < 1e-2 * table[0]


@pytest.mark.slow
@sparing("law", ["linear", "sine"], every=2)
def test_least_cam_under_a_rocker(law: str) -> None:
    (study,) = studies_of("cam-rocker-synthesis", "cam_synthesis", f'cam.law="{law}"').values()
    assert max(errors_of(study, "exact")) < 1e-14
    assert study.reference.error < 1e-12
    lines = errors_of(study, "lines of n")
    assert lines[-1] < 1e-2 * lines[0]
    raster = errors_of(study, "raster")
    # a square of the raster is 1.5/n of the base circle
    assert all(error < 2 * 1.5 / n for error, n in zip(raster, (10, 20, 40, 80, 160), strict=True))
    assert 1e-3 < min(errors_of(study, "textbook")) < 0.2


def test_tip_of_an_indexing_cam() -> None:
    (study,) = studies_of("cam-lantern", "indexing").values()
    assert max(errors_of(study, "root")) < 1e-14
    halved = series_of(study, "bisection")
    for point in halved.points:
        assert point.error is not None
        assert point.error < point.size + 1e-15
    table = errors_of(study, "table")
    assert table[-1] < 1e-3 * table[0]
