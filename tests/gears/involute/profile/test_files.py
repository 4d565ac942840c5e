"""CSV rows, SVG paths and DXF drawings read back."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from tmmcalc.errors import UsageError
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.profile.files import (
    fillet_rows,
    flank_rows,
    main_rows,
    outline_rows,
    svg_document,
    svg_path,
    write_dxf,
)
from tmmcalc.gears.involute.profile.flank import flank_of
from tmmcalc.gears.involute.profile.mesh import placings
from tmmcalc.gears.involute.profile.outline import Element, outline, tooth
from tmmcalc.gears.involute.profile.tables import fillet_table, flank_table, main_profile
from tmmcalc.gears.involute.wheel import Wheel

TOLERANCE, MODULE = 1e-4, 5.0
FLANK = flank_of(Wheel(13, 0.25), shape="circle")


def read_path(data: str) -> np.ndarray:
    """Points of an SVG path, y upward, arcs and cubics drawn finely."""
    points: list[complex] = []
    for command, numbers in re.findall(r"([MCAZ])([^MCAZ]*)", data):
        values = [float(number) for number in numbers.split()]
        if command == "A":
            radius, large, sweep, end = values[0], values[3], values[4], complex(values[5], -values[6])
            start = points[-1]
            assert (large, sweep) == (0, 0)
            # counter-clockwise as seen: the centre lies left of the chord
            chord = end - start
            middle = (start + end) / 2 + 1j * chord / abs(chord) * np.sqrt(radius**2 - abs(chord) ** 2 / 4)
            turn = np.angle((end - middle) / (start - middle))
            points += list(middle + (start - middle) * np.exp(1j * turn * np.linspace(0, 1, 20)[1:]))
            continue
        pairs = [complex(x, -y) for x, y in zip(values[::2], values[1::2], strict=True)]
        if command == "M":
            points += pairs
        for control in (pairs[i : i + 3] for i in range(0, len(pairs), 3) if command == "C"):
            a, (b, c, d) = points[-1], control
            t = np.linspace(0, 1, 30)[1:]
            points += list((1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d)
    return np.array(points)


@pytest.mark.parametrize("wheel", [Wheel(13, 0.25), Wheel(8, 0.7), Wheel(10, 0.0, 0.4)])
def test_svg_path_is_the_outline(wheel: Wheel) -> None:
    element = tooth(flank_of(wheel))
    points = read_path(svg_path(element, TOLERANCE, MODULE))
    assert points[0] == pytest.approx(points[-1], abs=1e-4)
    exact = MODULE * outline(element, tolerance=1e-5)
    assert off(points, exact) < 1.1 * TOLERANCE * MODULE
    assert off(exact[::7], points) < 1.1 * TOLERANCE * MODULE + 2e-3


def off(points: np.ndarray, polygon: np.ndarray) -> float:
    """Largest distance of points of the first tooth from the sides of a polygon."""
    points = points[np.abs(np.angle(points) - np.pi / 2) < 0.3][:400]
    a, chord = polygon[None, :], (np.roll(polygon, -1) - polygon)[None, :]
    chord = np.where(chord == 0, 1e-30, chord)
    part = np.clip(((points[:, None] - a) / chord).real, 0, 1)
    return float(np.abs(points[:, None] - a - part * chord).min(axis=1).max())


def test_svg_document_places_a_pair() -> None:
    pair = pair_of_shifts(Wheel(13, 0.25), Wheel(30, 0.15))
    elements = [tooth(flank_of(w, float(t))) for w, t in zip(pair.wheels, pair.tips, strict=True)]
    paths = [svg_path(e, 1e-3, 2.0, p) for e, p in zip(elements, placings(pair), strict=True)]
    root = ElementTree.fromstring(svg_document(paths, (-40, -20, 80, 140)))
    assert root.get("viewBox") == "-40 -120 80 140"
    assert len(root.findall(".//{http://www.w3.org/2000/svg}path")) == 2
    second = read_path(paths[1]) - 2j * float(pair.distance)
    assert np.abs(second).max() == pytest.approx(2 * float(pair.tips[1]), abs=1e-2)


def test_rows() -> None:
    points = outline(tooth(FLANK), points=20)
    header, *rows = outline_rows(points, 0.005)
    assert header == ["x[m]", "y[m]"]
    assert np.array(rows) @ [1, 1j] == pytest.approx(0.005 * points, rel=1e-15)
    header, *rows = main_rows(main_profile(FLANK, 0.0, 4), MODULE, "mm")
    assert header == ["phi[rad]", "X_T[mm]", "Y_T[mm]", "R_T[mm]"]
    assert rows[-1][3] == pytest.approx(0.151388, abs=1e-6)
    header, *rows = fillet_rows(fillet_table(FLANK, 0.0, np.zeros(1)), MODULE, "mm")
    assert len(header) == 7
    assert rows[0][3:5] == (0.0, 0.0)
    header, *rows = flank_rows(flank_table(FLANK, 0.0, 3), MODULE, "mm")
    assert [row[0] for row in rows] == ["fillet"] * 4 + ["involute"] * 4
    assert rows[-1][4] == pytest.approx(-1 / (MODULE * FLANK.wheel.base * FLANK.highest))


def test_dxf_holds_arcs_and_splines(tmp_path: Path) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    pair = pair_of_shifts(Wheel(13, 0.25), Wheel(30, 0.15))
    elements = [tooth(flank_of(w, float(t))) for w, t in zip(pair.wheels, pair.tips, strict=True)]
    placed: list = list(zip(elements, placings(pair, 0.1), strict=True))
    line = np.array([0j, 1j * float(pair.distance)])
    write_dxf(tmp_path / "pair.dxf", placed, TOLERANCE, MODULE, [("centres", line)])
    drawing = ezdxf.readfile(tmp_path / "pair.dxf")
    assert not drawing.audit().errors
    splines = drawing.modelspace().query('SPLINE[layer=="wheel_1"]')
    assert len(splines) == 2 * 13
    element, placing = placed[0]
    exact = MODULE * placing(outline(element, tolerance=1e-6))
    for spline in list(splines)[:2]:
        points = np.array([complex(p.x, p.y) for p in spline.construction_tool().approximate(60)])
        a, chord = exact[None, :], (np.roll(exact, -1) - exact)[None, :]
        part = np.clip(((points[:, None] - a) / chord).real, 0, 1)
        assert np.abs(points[:, None] - a - part * chord).min(axis=1).max() < 1.1 * TOLERANCE * MODULE
    for arc in drawing.modelspace().query('ARC[layer=="wheel_2"]'):
        assert arc.dxf.center.y == pytest.approx(MODULE * float(pair.distance))
        assert 0 < (arc.dxf.end_angle - arc.dxf.start_angle) % 360 < 360 / 30


def test_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    element: Element = tooth(FLANK)
    with pytest.raises(UsageError, match=r"tmmcalc\[cad\]"):
        write_dxf(tmp_path / "x.dxf", [(element, placings(pair_of_shifts(Wheel(20), Wheel(20)))[0])], 1e-3)
    assert not list(tmp_path.iterdir())
