"""The documents of the profile stage, the textbook's tables, and the files of outlines read back."""

from __future__ import annotations

import csv
import re
import sys
from io import StringIO
from math import pi
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from sparing import sparing

from gears.involute.profile.envelope import CASES
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.facts.profile import document as profile_document
from tmmcalc.gears.facts.profile import summary as profile_summary
from tmmcalc.gears.files import layer_of, outline_csv, outlines
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.involute.profile.mesh import Placing
from tmmcalc.gears.involute.profile.outline import outline
from tmmcalc.gears.meshing.booktables import book_tables
from tmmcalc.gears.meshing.members import Member
from tmmcalc.gears.meshing.meshoutlines import beside, mesh_placings, mesh_tracks
from tmmcalc.gears.meshing.outlines import Track, track
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.meshing.tooth import solve_profiles
from tmmcalc.report.outlinefiles import dxf, require_dxf, svg

M, FINE = 0.005, 5e-7


def solved(teeth: tuple[int, int], shifts: tuple[float, float], **more: Any) -> MeshPair:
    return solve_pair(PairTask(teeth, M, strategy="given", shifts=shifts, refuse=False, **more))


BOOK = solved((13, 30), (0.25, 0.15), fillet="circle")
RING = solved((20, 60), (0.1, 0.1), kind="internal", name="ring", cutter=Cutter(25, 0.0, 0.2))
RACK = solved((14, 0), (0.3, 0.0), kind="rack", name="rack", helix=0.3)
UNDER = solved((10, 30), (0.0, 0.0), name="under")


def expected(name: str, *keys: str) -> np.ndarray:
    return 1e-3 * np.array([[row[key] for key in keys] for row in CASES[name]["expected"]["table"]]).T


def test_main_profile_of_the_textbook() -> None:
    table = book_tables(Member(BOOK, 0), "pitch", 8000)
    assert table is not None
    found = table.main.columns
    roll = 1e3 * expected("IG-S05", "phi")[0]
    assert (found["phi[rad]"][0], found["phi[rad]"][-1]) == pytest.approx((roll[0], roll[-1]), abs=1e-7)
    assert (table.main.points[0], table.main.points[-1]) == ("A", "L")
    for header, column in zip(("X_T", "Y_T", "R_T"), expected("IG-S05", "X_T", "Y_T", "R_T"), strict=True):
        between = np.interp(-roll, -found["phi[rad]"], found[f"{header}[m]"])
        assert between == pytest.approx(column, abs=1e-9)


def test_fillet_of_the_textbook() -> None:
    names = ("phi", "X_S", "Y_S", "X", "Y", "R_S", "R")
    roll, *columns = expected("IG-S07", *names)
    rolls = 1e3 * roll[1:-1]
    table = book_tables(Member(BOOK, 1), "pitch", rolls=rolls)
    assert table is not None
    found = table.fillet.columns
    assert table.fillet.points[-2:] == ("L", "D")
    assert found["phi[rad]"] == pytest.approx([*rolls, 1e3 * roll[-1], 1e3 * roll[0]], abs=1e-7)
    for header, column in zip(names[1:], columns, strict=True):
        in_order = [*column[1:-1], column[-1], column[0]]
        assert found[f"{header}[m]"] == pytest.approx(in_order, abs=1e-6 if header.startswith("R") else 1e-7)
    # equal steps from D to L are the same table
    same = book_tables(Member(BOOK, 1), "pitch", 5)
    assert same is not None
    assert same.fillet.columns["X[m]"] == pytest.approx(found["X[m]"], abs=1e-9)


@pytest.mark.parametrize("axis", ["tooth", "space", "pitch", "reference"])
@pytest.mark.parametrize(("pair", "place"), [(BOOK, 0), (RING, 0), (RING, 1), (UNDER, 0)])
def test_axes_of_the_tables(pair: MeshPair, place: int, axis: Any) -> None:
    member, wheel = Member(pair, place), pair.sizes[place]
    table = book_tables(member, axis, 400)
    assert table is not None
    columns = table.main.columns
    places = columns["X_T[m]"] + 1j * (columns["Y_T[m]"] + wheel.base)
    angles, radii = np.angle(places) - pi / 2, np.abs(places)
    order = np.argsort(radii)
    if axis in ("pitch", "reference"):  # the flank crosses Y there
        radius = wheel.operating if axis == "pitch" else wheel.reference
        assert np.interp(radius, radii[order], angles[order]) == pytest.approx(0.0, abs=1e-6)
    else:
        profile = solve_profiles(Pairs((pair,), "", ()), 401).wheels[place]
        own = (profile.x + 1j * profile.y)[profile.part == "involute"]
        half = np.angle(own) - pi / 2
        turn = pi / wheel.teeth if axis == "space" else 0.0
        assert angles[::-1] == pytest.approx(half - turn, abs=1e-12)
    assert radii[0] == pytest.approx(wheel.tip, rel=1e-12)
    assert columns["R_T[m]"] == pytest.approx(np.sqrt(radii**2 - wheel.base**2), abs=1e-9)
    assert table.main.points[-1] == ("L" if place == 0 and pair is not UNDER else "F")


def test_fillet_of_helical_wheels_is_that_of_the_circle() -> None:
    """The table of the textbook, whatever rounds the outline: rho_t*, x_1S, phi_D = x_1S/r, R = rho_t + R_S."""
    helical = solved((14, 27), (0.5, 0.3), helix=0.26)
    table = book_tables(Member(helical, 0), rolls=np.array([-0.1]))
    assert table is not None
    assert (table.rounded, table.apart) == (True, True)
    angle = np.arctan(np.tan(np.radians(20)) / np.cos(0.26))
    rho, r = 0.25 * M / (1 - np.sin(angle)), 14 * M / (2 * np.cos(0.26))
    x = M * (0.5 - 1) * np.tan(angle) - rho * np.cos(angle)
    y = M * (0.5 - 1) + rho * np.sin(angle)
    assert table.radius == pytest.approx(rho, rel=1e-13)
    columns = table.fillet.columns
    assert columns["phi[rad]"][-1] == pytest.approx(x / r, rel=1e-12)
    assert columns["R[m]"] == pytest.approx(columns["R_S[m]"] + rho, rel=1e-12)
    base = helical.sizes[0].base
    assert np.hypot(columns["X[m]"], columns["Y[m]"] + base)[-1] == pytest.approx(helical.sizes[0].root, rel=1e-13)
    centre = np.hypot(columns["X_S[m]"], columns["Y_S[m]"] + base)[-1]
    assert centre == pytest.approx(r + y, rel=1e-13)
    joint = [
        (found.columns[f"X{under}[m]"], found.columns[f"Y{under}[m]"])
        for found, under in ((table.main, "_T"), (table.fillet, ""))
    ]
    assert (joint[0][0][-1], joint[0][1][-1]) == pytest.approx((joint[1][0][-2], joint[1][1][-2]), abs=1e-12)
    profile = solve_profiles(Pairs((helical,), "", ())).wheels[0]
    assert profile.centre == pytest.approx((x, y), rel=1e-12)
    assert profile.half_angle == pytest.approx((pi / 2 + np.tan(np.radians(20))) / 14, rel=1e-13)
    with pytest.raises(UsageError, match="circular") as caught:
        book_tables(Member(RING, 1), rolls=np.zeros(3))
    assert "--wheel" in (caught.value.remedy or "")
    assert book_tables(Member(RACK, 1)) is None


@pytest.mark.parametrize(("pair", "place"), [(BOOK, 0), (UNDER, 0), (RING, 1)])
def test_main_profile_at_rolls(pair: MeshPair, place: int) -> None:
    """R_T = r_b (phi + tan(alpha_t)) at the roll angles asked for, between the ends of the involute."""
    inside = [-0.05, 0.0, 0.08]
    table = book_tables(Member(pair, place), main_rolls=np.array([-9.0, *inside, 9.0]))
    assert table is not None
    found, base = table.main.columns, pair.sizes[place].base
    rolls = found["phi[rad]"]
    assert sorted(rolls[1:-1]) == pytest.approx(inside, abs=1e-15)
    assert table.main.points[1:-1] == ("", "", "")
    assert found["R_T[m]"] == pytest.approx(base * (rolls + np.tan(np.radians(20))), rel=1e-12)
    radii = np.hypot(found["X_T[m]"], found["Y_T[m]"] + base)
    assert radii**2 == pytest.approx(base**2 + found["R_T[m]"] ** 2, rel=1e-12)


def test_order_of_generation_turns_round_with_the_shift() -> None:
    for shift, order in ((0.25, ["L", "D", "A"]), (0.95, ["D", "L", "A"])):
        result = solve_profiles(Pairs((solved((30, 40), (shift, 0.0)),), "", ()))
        values = {
            key: value for fact in profile_document(result, "t").parts[0].facts for key, value in fact.values.items()
        }
        assert values["order"] == order
        starts = {name: values[f"phi_{name}[rad]"] for name in "LDA"}
        assert sorted(starts, key=lambda name: starts[name]) == order
    expected = CASES["IG-S11"]["expected"]
    assert values["x_1S[m]"] == pytest.approx(expected["x1S"] / 1000, abs=1e-9)
    assert values["y_1S[m]"] == pytest.approx(expected["y1S"] / 1000, abs=1e-9)
    assert values["psi[rad]"] == pytest.approx(expected["psi_rad"], abs=1e-8)


def test_document_tells_every_wheel() -> None:
    pairs = Pairs((BOOK, UNDER, RING, RACK), "", ())
    result = solve_profiles(pairs, 20)
    tables = [
        each
        for pair in pairs.pairs
        for place in (0, 1)
        if (each := book_tables(Member(pair, place), rolls=None)) is not None
    ]
    document = profile_document(result, "title", tables)
    assert len(document.parts) == len(result.wheels) == 8
    facts = {fact.label: fact.text for fact in document.parts[2].facts}
    assert facts["undercut"].startswith("yes: the involute begins 0.1357")
    assert "phi_F = -0.256326" in facts["roll angles"]
    assert {fact.label for fact in document.parts[7].facts} == {"rack", "above the datum line", "fillet"}
    assert not document.parts[7].parts
    view = document.parts[0].parts[0].table
    assert view is not None
    assert view.headers == ["point", "phi[rad]", "X_T[mm]", "Y_T[mm]", "R_T[mm]"]
    assert view.columns[4][0] == pytest.approx(23.65968, abs=1e-5)
    one = profile_document(result, "title", tables, wanted=["under/2"], everything=True)
    assert one.table is not None
    assert [part.title for part in one.parts] == ["wheel under/2"]
    assert set(one.table.columns[0]) == {"under"}
    stacked = profile_document(result, "title", tables, everything=True, asked=True).table
    assert stacked is not None
    assert stacked.headers[:6] == ["pair", "wheel", "table", "point", "phi[rad]", "X[m]"]
    assert len({len(column) for column in stacked.columns}) == 1
    summary = profile_summary(result, "profile").table
    assert summary is not None
    assert len(summary.columns[0]) == 8


def test_blank_where_nothing_is_cut() -> None:
    table = book_tables(Member(BOOK, 0), rolls=np.array([-0.5, -0.2]))
    assert table is not None
    result = solve_profiles(Pairs((BOOK,), "", ()), 20)
    people = profile_document(result, "t", [table]).parts[0].parts[1].table
    programs = profile_document(result, "t", [table], everything=True).parts[0].parts[1].table
    assert people is not None
    assert programs is not None
    assert people.columns[people.headers.index("X[mm]")][0] == ""
    assert programs.columns[programs.headers.index("X[m]")][0] == 0.0
    assert programs.columns[programs.headers.index("cut")] == [False, True, True, True]


def tracks() -> tuple[Track, ...]:
    return beside([mesh_tracks(pair, FINE, 0.05) for pair in (BOOK, UNDER, RING, RACK)])


def flattened(data: str) -> np.ndarray:
    """Points [mm] of an SVG path, y upward, arcs and cubics drawn finely."""
    points: list[complex] = []
    for command, numbers in re.findall(r"([MCALZ])([^MCALZ]*)", data):
        values = [float(number) for number in numbers.split()]
        if command == "A":
            radius, large, sweep, end = values[0], values[3], values[4], complex(values[5], -values[6])
            start = points[-1]
            assert (large, sweep) == (0, 0)
            chord = end - start
            centre = (start + end) / 2 + 1j * chord / abs(chord) * np.sqrt(radius**2 - abs(chord) ** 2 / 4)
            turn = np.angle((end - centre) / (start - centre))
            points += list(centre + (start - centre) * np.exp(1j * turn * np.linspace(0, 1, 9)[1:]))
            continue
        pairs = [complex(x, -y) for x, y in zip(values[::2], values[1::2], strict=True)]
        if command in "ML":
            points += pairs
            continue
        t = np.linspace(0, 1, 9)[1:]
        for b, c, d in (pairs[i : i + 3] for i in range(0, len(pairs), 3)):
            a = points[-1]
            points += list((1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d)
    return np.array(points)


def away(points: np.ndarray, polygon: np.ndarray) -> float:
    """Largest distance of points from the sides of a closed polygon."""
    run = np.roll(polygon, -1) - polygon
    part = np.clip(((points[:, None] - polygon) / np.where(run == 0, 1e-30, run)).real, 0, 1)
    return float(np.abs(points[:, None] - polygon - part * run).min(axis=1).max())


def exact(member: Member, placing: Placing) -> np.ndarray:
    """The outline by the room itself, a hundred times finer [m]."""
    turned = placing
    if member.shape == "ring":  # there a space stands on +Y
        turned = Placing(placing.turn + member.half_pitch, placing.centre)
    return member.module * turned(outline(member.element, tolerance=1e-2 * FINE / member.module))


@sparing("pair", [BOOK, UNDER, RING], every=3)
def test_svg_read_back(pair: MeshPair) -> None:
    drawn = mesh_tracks(pair, FINE, 0.05)
    root = ElementTree.fromstring(svg(outlines(drawn), FINE, "A & B").decode())
    assert root.get("width") == f"{float(root.get('viewBox', '').split()[2]):g}mm"
    paths = root.findall(".//{http://www.w3.org/2000/svg}path")
    assert [path.get("id") for path in paths] == [each.member.label for each in drawn]
    for path, each, placing in zip(paths, drawn, mesh_placings(pair, 0.05), strict=True):
        points = 1e-3 * flattened(path.get("d", ""))
        truth = exact(each.member, placing)
        near = np.abs(points - points[0]) < 3 * M
        around = np.abs(truth - points[0]) < 4 * M
        assert near.sum() > 60
        assert away(points[near], truth[around]) < FINE
        assert abs(points[0] - points[-1]) < FINE


@pytest.mark.slow
def test_dxf_read_back(tmp_path: Any) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    drawn = tracks()
    data = dxf(outlines(drawn))
    assert data == dxf(outlines(drawn))
    file = tmp_path / "gears.dxf"
    file.write_bytes(data)
    drawing = ezdxf.readfile(file)
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 4
    space = drawing.modelspace()
    for each in drawn:
        own = list(space.query(f'*[layer=="{layer_of(each)}"]'))
        ends = np.array([ends_of(entity) for entity in own])
        following = np.roll(ends[:, 0], -1) if each.closed else ends[1:, 0]
        assert np.abs(ends[: len(following), 1] - following).max() < 1e-9
        spline = next(entity for entity in own if entity.dxftype() == "SPLINE")
        points = np.array([complex(p.x, p.y) for p in spline.construction_tool().approximate(60)]) * 1e-3
        around = np.abs(each.polygon - points[0]) < 4 * M
        assert away(points, each.polygon[around]) < 2 * FINE


def ends_of(entity: Any) -> tuple[complex, complex]:
    if entity.dxftype() == "SPLINE":
        first, last = entity.control_points[0], entity.control_points[-1]
    elif entity.dxftype() == "ARC":
        first, last = entity.start_point, entity.end_point
    else:
        first, last = entity.dxf.start, entity.dxf.end
    return complex(first[0], first[1]), complex(last[0], last[1])


@pytest.mark.slow
def test_outline_of_the_wheel_and_its_csv() -> None:
    upright = Placing(0.0, 0j)
    for member in (Member(BOOK, 0), Member(UNDER, 0), Member(RING, 1)):
        one = track(member, FINE)
        truth = exact(member, upright)
        near, around = np.abs(one.polygon - one.polygon[0]) < 3 * M, np.abs(truth - one.polygon[0]) < 4 * M
        assert away(one.polygon[near], truth[around]) < 0.02 * FINE
        assert away(truth[around & (np.abs(truth - one.polygon[0]) < 2 * M)][::20], one.polygon) < 1.01 * FINE
    header, *rows = csv.reader(StringIO(outline_csv([track(Member(UNDER, 0), FINE)]).decode()))
    assert header == ["pair", "wheel", "x[m]", "y[m]"]
    points = track(Member(UNDER, 0), FINE).polygon
    assert [complex(float(x), float(y)) for *_, x, y in rows] == [*points.tolist(), points[0]]  # the polygon is closed
    tooth = track(Member(UNDER, 0), FINE, whole=False)
    assert len(outline_csv([tooth]).splitlines()) == 1 + len(tooth.polygon)
    assert outline_csv([track(Member(BOOK, 0), FINE)]).startswith(b"wheel,x[m],y[m]\n1,")


def test_tracks_beside_each_other_do_not_overlap() -> None:
    drawn = tracks()
    ends = [(each.polygon.real.min(), each.polygon.real.max()) for each in drawn]
    for k in range(2, len(drawn), 2):
        assert min(low for low, _ in ends[k : k + 2]) > max(high for _, high in ends[:k])


def test_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(UsageError, match=r"\[cad\]"):
        require_dxf()
