"""Pictures of gear trains: what is drawn against geometry, closed forms and the results that it shows."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from sparing import sparing

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from tmmcalc.api import run
from tmmcalc.cli.plot import ordered, picture_of
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.pictures.criteria import criteria_figure
from tmmcalc.gears.pictures.endview import extent
from tmmcalc.gears.pictures.placed import PlacedTrain, placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.train import chosen_rows, numbered_rows, train_figure
from tmmcalc.gears.scheme import layout_of
from tmmcalc.gears.trains import Trains
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.page import blank, settle


class Ordered(NamedTuple):
    spec: Any
    results: Any


RACK = math.radians(20)
RAISED = math.acos(math.cos(RACK) * 132 / 138)  # closes Z1 + 2 Z2 + Z3 = 132 against Z3 + Z4 = 138

TRAINS = {
    "unfolded2": ((17, 59, 17, 40), (0, 0), 1),
    "unfolded3": ((17, 59, 17, 44, 17, 35), (0, 0, 0), 1),
    "coaxial": ((17, 64, 17, 37), (2, 3), 3),
    "AIbar": ((18, 48, 114), (1,), 3),
    "AI": ((22, 118, 17, 97), (4, 7), 2),
    "AA": ((17, 64, 17, 37), (2, 3), 1),
    "II": ((60, 20, 25, 65), (1, 1), 3),
    "AII": ((20, 25, 28, 70, 73), (1, 1), 3),
    "2A-AA": ((18, 24, 66, 72), (1,), 3),
}
SPEC = """
[train]
layout = ["AIbar", "AI"]
ratio = "7.29"
tolerance = "0.1"
tolerance_kind = "absolute"
module_ratios = [[1, 1]]
z_max = 60
sum_max = 100

[strength]
torque = "75 N*m"
face_width = 0.6
permissible_contact = "600 MPa"
permissible_bending = "200 MPa"

[criteria]
objectives = ["mass", "inertia", "size", "error"]
"""


def sets_of(layout: str) -> ToothSets:
    teeth, modules, planets = TRAINS[layout]
    angles = [RACK] * len(layout_of(layout).meshes)
    if layout == "2A-AA":
        angles = [RAISED, RAISED, RACK]
    return ToothSets(layout, np.array([teeth]), np.array([modules]), np.array([angles]), planets)


def train_of(layout: str, **more: Any) -> PlacedTrain:
    return placed(sets_of(layout), 0, **more)


def drawn(train: PlacedTrain) -> tuple[Figure, Axes]:
    figure, (sheet,) = blank(1)
    finish = scheme_sheet(sheet, train, "")
    settle(figure)
    finish()
    return figure, figure.axes[0]


@cache
def sheet_of(layout: str) -> tuple[PlacedTrain, Figure, Axes]:
    train = train_of(layout)
    return train, *drawn(train)


def texts(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


def axes_of(figure: Figure, label: str) -> Axes:
    (found,) = [axes for axes in figure.axes if label in (axes.get_xlabel(), axes.get_ylabel())]
    return found


@sparing("layout", LAYOUTS, every=3)
class TestScheme:
    def test_circles_in_mesh_touch(self, layout: str) -> None:
        train = train_of(layout)
        for mesh in train.scheme.meshes:
            one, other = train.wheel(mesh.first), train.wheel(mesh.second)
            sign = 1 if not mesh.internal else -1
            for axis in one.axes if len(one.axes) > 1 else other.axes:
                other_axis = min(other.axes, key=lambda place: abs(place - axis)) if len(one.axes) > 1 else one.axes[0]
                apart = abs(axis - other_axis)
                sums = [abs(r + sign * q) for r, _ in one.pitch for q, _ in other.pitch]
                assert min(abs(total - apart) for total in sums) == pytest.approx(0, abs=1e-9 * train.height)

    def test_what_stands_on_the_sheet(self, layout: str) -> None:
        train, figure, axes = sheet_of(layout)
        said = texts(axes)
        for wheel in train.wheels:
            assert wheel.name in said
            assert f"$z_{{{wheel.name}}}$ = {wheel.teeth}" in said
        assert ("H" in said) is train.scheme.planetary
        (table,) = figure.axes[1].tables
        first = [table[row, 0].get_text().get_text() for row in range(1, len(train.wheels) + 1)]
        assert first == [wheel.name for wheel in train.wheels]

    def test_both_directions_have_one_scale_and_all_is_inside(self, layout: str) -> None:
        _, _, axes = sheet_of(layout)
        box = axes.get_window_extent()
        x, y = axes.get_xlim(), axes.get_ylim()
        assert (x[1] - x[0]) / box.width == pytest.approx((y[1] - y[0]) / box.height, rel=1e-9)
        everything = np.concatenate([np.asarray(line.get_xydata()) for line in axes.lines])
        assert x[0] < everything[:, 0].min() < everything[:, 0].max() < x[1]
        assert y[0] < everything[:, 1].min() < everything[:, 1].max() < y[1]

    def test_bars_of_the_side_view_reach_the_pitch_circles(self, layout: str) -> None:
        train, _, axes = sheet_of(layout)
        across = 1 if train.scheme.branched else 0
        heights = {
            round(float(np.ptp(patch.get_xy()[:, across])), 6) for patch in axes.patches if isinstance(patch, Polygon)
        }
        external = [wheel for wheel in train.wheels if not wheel.internal]
        assert {round(2 * wheel.rolling, 6) for wheel in external} <= heights


class TestPlaces:
    def test_gap_of_neighbours(self) -> None:
        gap = train_of("AIbar").gap
        assert gap is not None
        assert gap.size == pytest.approx(2 * 33 * math.sin(math.pi / 3) - 48 - 2)
        assert abs(gap.ends[0] - gap.ends[1]) == pytest.approx(gap.size)
        assert gap.ends[0].imag == pytest.approx(gap.ends[1].imag) == pytest.approx(-16.5)
        assert train_of("AI").gap is None

    def test_known_modules_are_metres(self) -> None:
        train = train_of("coaxial", module=np.array([0.002, 0.003]), width=np.array([0.03, 0.05]))
        assert train.distances == (pytest.approx(0.081), pytest.approx(0.081))
        assert 2 * train.wheel("3").reference == pytest.approx(0.111)
        _, axes = drawn(train)
        (scale,) = [text for text in texts(axes) if text.startswith("scale")]
        part = float(scale.removeprefix("scale 1:"))
        box = axes.get_window_extent()
        paper = box.width / axes.figure.dpi * 0.0254
        assert (axes.get_xlim()[1] - axes.get_xlim()[0]) / paper == pytest.approx(part, rel=1e-3)

    def test_modules_that_are_not_chosen_grow_with_the_cube_root_of_the_ratio(self) -> None:
        train = train_of("unfolded3")
        assert train.estimated
        assert train.modules[1] ** 3 == pytest.approx(59 / 17)
        assert train.modules[2] ** 3 == pytest.approx(59 / 17 * 44 / 17)

    def test_planets_stand_on_rays_from_the_upward_one(self) -> None:
        axes = train_of("2A-AA").wheel("3").axes
        assert axes[0] == pytest.approx(69j)
        assert axes[1] / axes[0] == pytest.approx(np.exp(2j * np.pi / 3))

    def test_raised_pressure_angles_give_a_planet_in_two_planes_two_circles(self) -> None:
        wheel = train_of("2A-AA").wheel("3")
        assert [plane for _, plane in wheel.pitch] == [0, 1]
        assert wheel.pitch[0][0] == pytest.approx(33 * 138 / 132)
        assert wheel.pitch[1][0] == pytest.approx(33)

    def test_extent_of_a_ring(self) -> None:
        corners = extent(train_of("AIbar"))
        assert corners.real.max() == pytest.approx(57 + 2.5)


@pytest.fixture(scope="module")
def order(tmp_path_factory: pytest.TempPathFactory) -> Ordered:
    folder = tmp_path_factory.mktemp("gears")
    file = folder / "gears.toml"
    file.write_text(SPEC)
    spec = load_spec(file)
    return Ordered(spec, run(spec, target="criteria").results)


@pytest.fixture(scope="module")
def of_train(order: Ordered) -> Figure:
    return train_figure(order.results["train"], numbered_rows(order.results["train"], 2))


@pytest.fixture(scope="module")
def of_criteria(order: Ordered) -> Figure:
    return criteria_figure(order.results["criteria"], order.results["train"])


class TestTrain:
    @pytest.mark.slow
    def test_every_candidate_is_in_the_bars(self, order: Ordered, of_train: Figure) -> None:
        panels = [axes for axes in of_train.axes if axes.get_xlabel() == "combinations of wheels"]
        variants = order.results["train"].variants
        assert len(panels) == len(variants)
        for axes, variant in zip(panels, variants, strict=True):
            left, *removed, candidates = [round(bar.get_width()) for bar in axes.patches]
            assert candidates == variant.synthesis.candidates == left + sum(removed)
            assert left == variant.synthesis.count
            assert axes.get_xscale() == "log"

    def test_every_set_is_a_point(self, order: Ordered, of_train: Figure) -> None:
        panels = [axes for axes in of_train.axes if axes.get_xlabel() == "$z_1 + z_2$"]
        for axes, variant in zip(panels, order.results["train"].variants, strict=True):
            points = np.concatenate([np.asarray(line.get_xydata()) for line in axes.lines[:2]])
            assert len(points) == variant.synthesis.count > 2
            z = {wheel: variant.sets.of(wheel).astype(float) for wheel in variant.sets.scheme.wheels}
            ratio = 1 + (z["3"] / z["1"] if "2'" not in z else z["2"] * z["3"] / z["1"] / z["2'"])
            error = 100 * (ratio / 7.29 - 1)
            assert sorted(points[:, 1]) == pytest.approx(sorted(error), abs=1e-9)
            assert set(points[:, 0]) == set(z["1"] + z["2"])
            assert "/".join(map(str, variant.sets.teeth[1])) in texts(axes)

    def test_points_of_the_task_lie_on_the_curves(self, of_train: Figure) -> None:
        wheel = axes_of(of_train, "$i_{1H}$")
        points = [np.asarray(line.get_xydata())[0] for line in wheel.lines if line.get_marker() == "o"]
        eta0 = 0.975 * 0.985
        assert all(point == pytest.approx([7.29, eta0 + (1 - eta0) / 7.29]) for point in points)
        assert len(points) == 2
        modules = axes_of(of_train, "tooth ratio $U$")
        (point,) = [np.asarray(line.get_xydata())[0] for line in modules.lines if line.get_marker() == "o"]
        first = (point[1] ** 4 * 6.29) ** (1 / 3)  # mu*^4 = U1^2/U2 with U1 U2 = U, and coaxiality (4.21)
        assert first + 1 == pytest.approx(point[1] * (6.29 / first - 1), rel=1e-9)

    def test_limits_by_the_number_of_planets(self, of_train: Figure) -> None:
        axes = axes_of(of_train, "number of planets $K$")
        tops = [bar.get_height() for bar in axes.patches]
        table = [13.92, 5.82, 3.85, 3.00, 2.53, 2.23], [11.29, 4.62, 2.99, 2.29, 1.91, 1.66]  # textbook 4.7, cut
        for found, printed in zip((tops[:6], tops[6:]), table, strict=True):
            assert all(abs(top - value) < 0.011 for top, value in zip(found, printed, strict=True))

    def test_a_set_that_there_is_not(self, order: Ordered) -> None:
        most = max(len(variant.sets) for variant in order.results["train"].variants)
        for choose in (0, most + 1):
            with pytest.raises(UsageError, match=f"no tooth set {choose}"):
                numbered_rows(order.results["train"], choose)

    def test_of_compared_trains_the_one_that_is_chosen(self, order: Ordered) -> None:
        """Every row of the trains compared, found among all sets of its variant by its teeth and modules."""
        result, selection = order.results["train"], order.results["criteria"]
        pool = selection.pool
        for choose in (None, *range(1, len(pool) + 1)):
            rows = chosen_rows(result, selection, choose)
            place = selection.winner.place if choose is None else choose - 1
            (at,) = [k for k, row in enumerate(rows) if row is not None]
            teeth = result.variants[at].sets.teeth[rows[at]]
            assert teeth.tolist() == selection.variants[at].sets.teeth[pool.row[place]].tolist()
        assert rows != chosen_rows(result, selection)
        with pytest.raises(UsageError, match=r"no row 0 of criteria\.csv"):
            chosen_rows(result, selection, 0)


class TestCriteria:
    @pytest.mark.slow
    def test_front_and_winner(self, order: Ordered, of_criteria: Figure) -> None:
        result = order.results["criteria"]
        axes = axes_of(of_criteria, "mass of moving wheels $M$, kg")
        edge, rings, star = (np.asarray(line.get_xydata()) for line in axes.lines[:3])
        pool = result.pool
        shown = sum(len(cloud.get_offsets()) for cloud in axes.collections)
        beyond = [int(text.split()[0]) for text in texts(axes) if text.endswith("beyond the picture")]
        assert shown + sum(beyond) == len(pool)
        assert np.all(rings <= [axes.get_xlim()[1], axes.get_ylim()[1]])
        assert rings.tolist() == np.column_stack((pool.mass, pool.inertia))[result.front].tolist()
        assert star[0, 1] == pool.inertia.min()
        # nothing lies below and left of the border
        corners = edge[::2]
        for x, y in corners:
            assert not np.any((pool.mass < x) & (pool.inertia < y))
        assert np.all(np.diff(corners[:, 0]) >= 0)
        assert np.all(np.diff(corners[:, 1]) <= 0)

    def test_all_pairs_of_four_criteria(self, of_criteria: Figure) -> None:
        named = [
            axes for axes in of_criteria.axes if axes.lines and axes.get_xlabel().startswith(("inertia, ", "size, "))
        ]
        assert len(named) == 2
        assert sum(bool(axes.lines) and axes.axison for axes in of_criteria.axes) == 1 + 6

    def test_rows_are_numbered_from_1(self, order: Ordered, of_criteria: Figure) -> None:
        """As in criteria.csv and in the text, of which the winner is row ``place + 1``."""
        result = order.results["criteria"]
        axes = axes_of(of_criteria, "mass of moving wheels $M$, kg")
        legend = axes.get_legend()
        assert legend is not None
        assert f"row {result.winner.place + 1}, chosen" in [text.get_text() for text in legend.get_texts()]
        numbers = {int(text) for text in texts(axes) if text.isdigit()}
        assert numbers
        assert numbers <= {row + 1 for row in result.front.tolist() if row != result.winner.place}

    @pytest.mark.slow
    def test_the_train_that_is_drawn(self, order: Ordered) -> None:
        result = order.results["criteria"]
        for choose in (None, 1):
            figure = criteria_figure(result, order.results["train"], choose)
            place = result.winner.place if choose is None else choose - 1
            sets = result.variants[result.pool.variant[place]].sets
            (table,) = [table for axes in figure.axes for table in axes.tables]
            teeth = [int(table[k + 1, 1].get_text().get_text()) for k in range(len(sets.scheme.wheels))]
            assert teeth == sets.teeth[result.pool.row[place]].tolist()
            assert table[0, 4].get_text().get_text() == "b, mm"

    def test_a_row_that_there_is_not(self, order: Ordered) -> None:
        result = order.results["criteria"]
        for choose in (0, len(result.pool) + 1):
            with pytest.raises(UsageError, match=f"no row {choose}"):
                criteria_figure(result, order.results["train"], choose)


@pytest.mark.slow
@pytest.mark.parametrize("stage", ["train", "criteria"])
def test_equal_results_give_equal_bytes(order: Ordered, stage: str, tmp_path: Path) -> None:
    pictures = []
    results = dict(order.results) | {"train": Trains(order.results["train"].variants[:1])}
    for name in ("one.svg", "two.svg"):
        ordered(stage, order.spec, results, {"--choose": "1"}, tmp_path / name)
        pictures.append((tmp_path / name).read_bytes())
    assert pictures[0] == pictures[1]
    assert pictures[0].startswith(b"<?xml")


def test_choose_belongs_to_gears() -> None:
    with pytest.raises(UsageError, match="--choose cannot be used with the picture of kinematics"):
        picture_of("kinematics", {"--choose": "1"})
