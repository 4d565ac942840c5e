"""Outlines, SVG, DXF, tables for machines; columns, polar angles, documents, the stored form."""

import csv
import re
from io import StringIO
from math import pi, radians

import numpy as np
import pytest
from sparing import sparing

from cams.test_law_result import same
from cams.turns import task_of, turn
from tmmcalc.cams.facts.cam_profile import document as profile_document
from tmmcalc.cams.facts.cam_profile import summary as profile_summary
from tmmcalc.cams.files.profile import nc_table, outlines
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile import Profile, solve_profile
from tmmcalc.cams.profile.columns import polar_angle, profile_columns
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.outline import adaptive, outline
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.report.outlinefiles import dxf, svg
from tmmcalc.report.outlines import Bow, Cubics

STEM = turn("cosine", "shun", rise=80, high=30, back=100)
ROCKER = turn("sine", "const", rise=80, high=0, back=100, stroke=radians(20))
SIZES = {"roller": 0.006, "centres": 0.1, "rocker": 0.09}
SCENES = (
    [(STEM, Follower("translating", 0.05, 0.006 * sense, 0.008, sense=sense), {"tool": 0.02}) for sense in (1, -1)]
    + [
        (
            ROCKER,
            Follower("oscillating", radians(35), assembly=d, sense=sense, **SIZES),
            {"closure": "groove", "tool": 0.004},
        )
        for sense in (1, -1)
        for d in (1, -1)
    ]
    + [(turn("sine", rise=90, back=90, stroke=0.01), Follower("flat", 0.04, sense=sense), {}) for sense in (1, -1)]
)


def solved(scene, **more):
    program, follower, asked = scene
    return solve_profile(task_of(program, follower.kind, **{**asked, **more}), follower)


def from_polygon(points, polygon):
    """Distances of points from a closed polygon."""
    a, b = polygon, np.roll(polygon, -1)
    along = np.clip(((points[:, None] - a) * np.conj(b - a)).real / np.abs(b - a) ** 2, 0, 1)
    return np.min(np.abs(points[:, None] - (a + along * (b - a))), axis=1)


@sparing("scene", SCENES, every=4)
@pytest.mark.parametrize("tolerance", [1e-4, 2e-6])
def test_chords_keep_the_tolerance_of_the_true_curve(scene, tolerance):
    program, follower, _ = scene
    rim = Rim(follower, program)
    polygon = outline(rim, "profile", follower.roller, tolerance).polygon
    true = follower.placed(rim.at(np.linspace(0, 2 * pi, 1501)).offset(follower.roller))
    away = from_polygon(true, polygon)
    assert np.max(away) <= tolerance
    assert np.max(away) > tolerance / 50  # not far finer than was asked


@pytest.mark.parametrize("scene", SCENES)
def test_outlines_are_closed_counter_clockwise_chains_with_exact_arcs(scene):
    program, follower, _ = scene
    found = outline(Rim(follower, program), "profile", follower.roller, 1e-5)
    ends = [(p.ends if isinstance(p, Bow) else (p.control[0, 0], p.control[-1, 3])) for p in found.pieces]
    for (_, end), (start, _) in zip(ends, [*ends[1:], ends[0]], strict=True):
        assert abs(end - start) < 1e-15
    x, y = found.polygon.real, found.polygon.imag
    assert np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) > 0
    arcs = [piece for piece in found.pieces if isinstance(piece, Bow)]
    dwells = [phase for phase in program.phases if not phase.moves]
    assert sorted(arc.sweep for arc in arcs) == pytest.approx(sorted(phase.angle for phase in dwells), rel=1e-13)
    assert all(arc.centre == 0 for arc in arcs)


@sparing("scene", SCENES, every=4)
def test_cubics_keep_the_tolerance(scene):
    program, follower, _ = scene
    rim, tolerance = Rim(follower, program), 1e-6
    dense = outline(rim, "profile", follower.roller, 1e-8).polygon
    t = np.array([0.13, 0.37, 0.5, 0.81])[:, None]
    weights = np.stack(((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3))
    for piece in outline(rim, "profile", follower.roller, tolerance).pieces:
        if isinstance(piece, Cubics):
            points = np.einsum("ikl,ni->kn", weights, piece.control).ravel()
            assert np.max(from_polygon(points, dense)) <= tolerance


def test_more_points_where_the_tolerance_is_finer_by_its_root():
    rim = Rim(SCENES[0][1], STEM)
    counts = [len(adaptive(rim, 0.008, tolerance)[0]) for tolerance in (1e-5, 1e-7)]
    assert 5 < counts[1] / counts[0] < 20


def test_a_tolerance_that_nobody_can_use():
    with pytest.raises(UsageError, match="too fine"):
        outline(Rim(SCENES[0][1], STEM), "profile", 0.0, 1e-13)


@pytest.mark.parametrize("scene", SCENES)
def test_polar_angles_run_on_without_jumps(scene):
    found = solved(scene)
    phi = found.positions.phi
    for wall in found.walls:
        angle = polar_angle(found.follower, phi, wall.points)
        plain = np.arctan2(-wall.points.real, wall.points.imag)
        np.testing.assert_allclose(np.exp(1j * angle), np.exp(1j * plain), atol=1e-12)
        assert np.max(np.abs(np.diff(angle))) < 0.1
        assert abs(angle[-1] - angle[0]) == pytest.approx(2 * pi, rel=1e-12)


@pytest.mark.parametrize("scene", SCENES)
def test_columns_hold_every_curve_in_si(scene):
    found = solved(scene)
    columns = profile_columns(found)
    lengths = {len(column) for column in columns.values()}
    assert lengths == {len(found.positions.labels)}
    np.testing.assert_allclose(np.hypot(columns["x_w[m]"], columns["y_w[m]"]), columns["R_w[m]"], rtol=1e-14)
    np.testing.assert_allclose(np.hypot(columns["n_x"], columns["n_y"]), 1, rtol=1e-14)
    assert ("x_o[m]" in columns) == (found.outer is not None)
    assert ("x_t[m]" in columns) == (found.tool is not None)
    if not found.flat:
        rho = 1 / columns["kappa_c[1/m]"] - found.follower.roller
        np.testing.assert_allclose(1 / columns["kappa_w[1/m]"], rho, rtol=1e-9)


@pytest.mark.parametrize("scene", SCENES)
def test_round_trip(scene):
    found = solved(scene)
    assert same(from_record(Profile, to_record(found)), found)


def test_round_trip_of_a_profile_with_faults():
    found = solve_profile(task_of(turn("cosine"), report_faults=True), Follower("translating", 0.055, roller=0.04))
    assert found.working.crossings
    assert same(from_record(Profile, to_record(found)), found)


def rows_of(data):
    return list(csv.DictReader(StringIO(data.decode())))


def test_the_table_for_a_machine_follows_the_tool():
    found = solved(SCENES[1])
    rows = rows_of(nc_table(found, STEM, 1e-5))
    assert {row["curve"] for row in rows} == {"tool path"}
    points = np.array([complex(float(row["X[mm]"]), float(row["Y[mm]"])) for row in rows])
    beside = np.array([complex(float(row["X_w[mm]"]), float(row["Y_w[mm]"])) for row in rows])
    normal = np.array([complex(float(row["N_x"]), float(row["N_y"])) for row in rows])
    np.testing.assert_allclose(points - beside, 20 * normal, atol=2e-4)
    polar = np.array([float(row["alpha[deg]"]) for row in rows])
    assert np.all(np.diff(polar) < 0)  # the cam turns the other way
    exact = found.follower.placed(
        Rim(found.follower, STEM).at(np.radians([float(r["phi[deg]"]) for r in rows])).offset(-0.012)
    )
    np.testing.assert_allclose(points, 1e3 * exact, atol=2e-4)


def test_the_table_of_a_groove_has_both_walls_with_normals_off_the_metal():
    scene = SCENES[2]
    found = solved(scene, tool=None)
    rows = rows_of(nc_table(found, ROCKER, 1e-5))
    assert list(dict.fromkeys(row["curve"] for row in rows)) == [
        "working profile",
        "second wall",
    ]
    pitch = Rim(scene[1], ROCKER)
    for row in rows[::40]:
        point = complex(float(row["X[mm]"]), float(row["Y[mm]"])) / 1e3
        normal = complex(float(row["N_x"]), float(row["N_y"]))
        phi = np.radians([float(row["phi[deg]"])])
        centre = scene[1].placed(pitch.at(phi).points)[0]
        assert abs(point + 0.006 * normal - centre) < 1e-7


def test_no_table_of_what_cannot_be_cut():
    follower = Follower("translating", 0.055, roller=0.01)
    found = solve_profile(task_of(turn("cosine"), tool=0.12), follower)
    with pytest.raises(NoSolutionError, match="tool path cannot be cut") as error:
        nc_table(found, turn("cosine"), 1e-5)
    assert "96.4286 mm" in error.value.remedy
    found = solve_profile(task_of(turn("cosine"), report_faults=True), Follower("translating", 0.055, roller=0.04))
    with pytest.raises(NoSolutionError, match="working profile cannot be cut"):
        nc_table(found, turn("cosine"), 1e-5)


def test_drawings_are_to_scale_and_equal_each_time():
    program, follower, _ = SCENES[0]
    found = solved(SCENES[0])
    drawn = outlines(found, program, 1e-5)
    assert [each.name for each in drawn] == ["pitch curve", "working profile", "tool path", "base circle"]
    data = svg(drawn, 1e-5, "cam")
    assert data == svg(outlines(found, program, 1e-5), 1e-5, "cam")
    text = data.decode()
    assert 'id="working profile"' in text
    path = re.search(r'id="working profile" d="M([\d.-]+) ([\d.-]+)', text)
    start = Rim(follower, program).at(np.zeros(1)).offset(follower.roller)[0]
    assert float(path[1]) == pytest.approx(1e3 * start.real, abs=1e-3)
    assert float(path[2]) == pytest.approx(-1e3 * start.imag, abs=1e-3)


def test_dxf_has_a_layer_of_each_curve():
    ezdxf = pytest.importorskip("ezdxf")
    program = SCENES[0][0]
    data = dxf(outlines(solved(SCENES[0]), program, 1e-5))
    drawing = ezdxf.read(StringIO(data.decode()))
    kinds = {(entity.dxf.layer, entity.dxftype()) for entity in drawing.modelspace()}
    assert {("working profile", "ARC"), ("working profile", "SPLINE"), ("base circle", "ARC")} <= kinds


def test_documents():
    found = solved(SCENES[0])
    document = profile_document(found, "profile")
    facts = {fact.label: fact for fact in document.facts}
    assert facts["largest roller"].values["roller_max[m]"] == found.inner_reach.distance
    assert facts["largest tool"].values["tool_max[m]"] == found.largest_tool
    assert "rho_c[mm]" in document.table.headers
    assert len(document.table.columns[0]) <= 50
    whole = profile_document(found, "profile", everything=True).table
    assert "kappa_c[1/m]" in whole.headers
    assert len(whole.columns[0]) == len(found.positions.labels)
    assert profile_summary(found, "profile").table is None
    few = profile_document(found, "profile", patterns=["x_*"], rows=[0]).table
    assert list(few.headers) == ["i", "x_c[mm]", "x_w[mm]", "x_t[mm]"]


def test_the_face_in_the_users_sense():
    right, left = (solved(SCENES[k], margin=0.002).face for k in (6, 7))
    assert (right.left, right.right) == (left.right, left.left)
    assert right.length == pytest.approx(right.left + right.right + 0.004)


def test_extreme_scenes():
    tiny = turn("cosine", "const", rise=5, high=0, back=40, stroke=1e-6)
    found = solve_profile(task_of(tiny), Follower("translating", 0.05, roller=0.01))
    assert found.working.sound
    assert found.inner_reach.distance < 0.06
    huge = turn("shun", rise=120, high=0, back=120, stroke=1.0)
    found = solve_profile(task_of(huge), Follower("translating", 2.0, roller=0.05))
    assert found.working.sound
    to_record(found)
