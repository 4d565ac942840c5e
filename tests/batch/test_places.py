"""Places that are chosen while one goes on: the same results as points have, here and in other processes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tmmcalc.batch.choice import local
from tmmcalc.batch.places import SOLVER, Place, solve_alike, solve_places
from tmmcalc.batch.points import solve_points
from tmmcalc.batch.preparing import prepared
from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.stacked_columns import Columns
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import UsageError

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
CRANK, RAM = "mechanism.links[id=1].points.A[0]", "mechanism.links[id=5].mass"
NAMES = ("kinematics.stroke_D[m]", "forces.max(R_A)[N]", "forces.M_drive@3[N*m]")


@pytest.fixture(scope="module")
def frame() -> Task:
    task = frame_of(SHAPER, ["mechanism.grid.positions=18"], [CRANK, RAM], NAMES)
    nominal = np.array(task.values(0))
    return replace(task.at([nominal.tolist(), (0.9 * nominal).tolist(), (1.1 * nominal).tolist()]), solver=SOLVER)


def places(count: int) -> list[Place]:
    rng = np.random.default_rng(5)
    return [Place(7 + k, (200 * x, 190 * y)) for k, (x, y) in enumerate(0.9 + 0.2 * rng.random((count, 2)))]


def test_a_frame_has_the_keys_with_their_values(frame: Task) -> None:
    assert [axis.name for axis in frame.axes] == [f"{CRANK}[mm]", f"{RAM}[kg]"]
    assert frame.values(0) == (200.0, 190.0)
    with pytest.raises(UsageError, match="is no number"):
        frame_of(SHAPER, (), ["project.title"], NAMES)


@pytest.mark.slow
def test_places_are_points(frame: Task) -> None:
    asked = places(40)
    rows = solve_places(frame, asked)
    assert [row.point for row in rows] == [place.point for place in asked]
    assert {row.alone for row in rows} == {""}
    alone = solve_points(frame.at([place.values for place in asked]), range(40))
    for one, other in zip(rows, alone, strict=True):
        assert one.names == other.names == NAMES
        assert list(one.values) == pytest.approx(list(other.values), rel=1e-10)


def test_a_place_without_a_solution_says_why(frame: Task) -> None:
    (bad, good) = solve_places(frame, [Place(0, (900.0, 190.0)), Place(1, (200.0, 190.0))])
    assert bad.status.startswith("failed")
    assert bad.reason
    assert good.ok


@pytest.mark.slow
def test_places_in_other_processes_are_the_same_to_the_last_digit(frame: Task) -> None:
    pytest.importorskip("joblib")
    asked = places(24)
    blocks = [asked[:12], asked[12:]]
    here = {row.point: row for block in blocks for row in solve_places(frame, block)}
    said: list[str] = []
    there = {row.point: row for rows in local(2, said.append)(frame, blocks) for row in rows}
    assert there == here
    assert not said


@pytest.mark.slow
def test_coordinates_on_both_sides_of_nothing_are_solved_together(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pins off by a clearance, whose nominal coordinates are 0: their specs are read once a combination of signs."""
    from tmmcalc.batch.stacked_inputs import Inputs

    pins = [f"mechanism.links[id={link}].points.{point}" for link, point in ((1, "O"), (2, "A"), (3, "B"))]
    keys = [f"{pin}[{axis}]" for pin in pins for axis in (0, 1)]
    frame = frame_of(SHAPER, ["mechanism.grid.positions=18"], keys, NAMES)
    frame = replace(frame.at([[0.0] * 6, [-5e-5] * 6, [5e-5] * 6]), solver=SOLVER)
    angles = 2 * np.pi * np.random.default_rng(3).random((400, 3, 1))
    moved = (5e-5 * np.concatenate([np.cos(angles), np.sin(angles)], axis=2)).reshape(400, 6).tolist()
    asked = [Place(at, tuple(values)) for at, values in enumerate(moved)]
    solve_places(frame, asked[:1])  # prepares
    read: list[int] = []
    own = Inputs._read

    def counted(self: Inputs, values: Any) -> Any:
        read.append(1)
        return own(self, values)

    monkeypatch.setattr(Inputs, "_read", counted)
    rows = solve_places(frame, asked)
    assert {row.alone for row in rows} == {""}
    assert len(read) < 60
    backwards = solve_places(frame, asked[::-1])[::-1]
    assert values_of(backwards) == pytest.approx(values_of(rows), rel=1e-13)
    alone = solve_points(frame.at([each.values for each in asked[::20]]), range(20))
    assert values_of(rows[::20]) == pytest.approx(values_of(alone), rel=1e-10)


def values_of(rows: list[Row]) -> NDArray[np.floating]:
    return np.array([list(row.values) for row in rows])


def test_places_about_one_point_alone_are_solved_as_they_are() -> None:
    """What is prepared by the point of the spec alone knows no slopes: nothing of it may be taken for another place."""
    point = replace(frame_of(SHAPER, (), [CRANK, RAM], NAMES), solver=SOLVER)
    (row,) = solve_places(point, [Place(0, (210.0, 180.0))])
    (alone,) = solve_points(point.at([(210.0, 180.0)]), range(1))
    assert list(row.values) == pytest.approx(list(alone.values), rel=1e-10)


@pytest.mark.slow
def test_transmission_angles_of_many_are_those_of_each(frame: Task) -> None:
    """Found at once, between positions too; a place that is not like the others is left out where it is not asked."""
    angles = tuple(
        f"kinematics.{kind}_{group}[deg]"
        for group in ("RPR(2,3)", "RRP(4,5)")
        for kind in ("transmission_min", "pressure_max")
    )
    task = replace(frame, patterns=angles, targets=("kinematics",))
    assert isinstance(prepared(task), Columns)
    asked = [*places(40), Place(99, (900.0, 190.0))]
    rows = solve_alike(task, asked)
    assert [row.point for row in rows] == [place.point for place in asked[:-1]]
    alone = solve_points(task.at([place.values for place in asked[:-1]]), range(40))
    for one, other in zip(rows, alone, strict=True):
        own = dict(zip(other.names, other.values, strict=True))
        assert {*one.names} == {*angles}
        assert list(one.values) == pytest.approx([own[name] for name in one.names], rel=1e-9, abs=1e-9)
    assert len({row.values[one.names.index(angles[2])] for row in rows}) == 40
