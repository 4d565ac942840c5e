"""Files and pictures of an indexing drive: equal bytes, chords that keep the tolerance, closed outlines."""

from __future__ import annotations

import csv
from dataclasses import replace
from io import StringIO
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.indexing_scene import SCENES, task
from tmmcalc.cams.facts.indexing import document as indexing_document
from tmmcalc.cams.facts.indexing import summary as indexing_summary
from tmmcalc.cams.files.indexing import nc_table, outlines
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.columns import indexing_columns
from tmmcalc.cams.indexing.laws import StepLaw, step_law
from tmmcalc.core.errors import UsageError
from tmmcalc.report.outlinefiles import dxf, svg
from tmmcalc.report.outlines import Bow, Cubics

GIVEN = SCENES["3-4-5"]
FOUND = solve_indexing(GIVEN)


def rows_of(data: bytes) -> list[dict[str, str]]:
    return list(csv.DictReader(StringIO(data.decode())))


def ends_of(piece) -> tuple[complex, complex]:
    return (piece.control[0, 0], piece.control[-1, -1]) if isinstance(piece, Cubics) else piece.ends


@sparing("name", SCENES, every=3)
def test_outlines_are_closed_chains(name: str) -> None:
    given = replace(SCENES[name], tolerance=1e-5, shaft=0.004)
    found = solve_indexing(given)
    pitch, working, base, shaft = outlines(given, found)
    assert [each.name for each in (pitch, working, base, shaft)] == [
        "pitch curve",
        "working profile",
        "base circle",
        "shaft",
    ]
    for outline in (pitch, working):
        for one, other in zip(outline.pieces, (*outline.pieces[1:], outline.pieces[0]), strict=True):
            assert ends_of(one)[1] == pytest.approx(ends_of(other)[0], abs=1e-12)
        arcs = [piece for piece in outline.pieces if isinstance(piece, Bow)]
        assert [arc.sweep for arc in arcs] == pytest.approx([pi - given.step] * 2)
        points = outline.polygon
        assert 0.5 * (np.conj(points) * np.roll(points, -1)).imag.sum() > 0  # counter-clockwise


def test_the_two_cams_are_one_profile_half_a_turn_apart() -> None:
    """The groove of the profile stands where the rear cam has its lobe: half a turn on, rotated."""
    rows = rows_of(nc_table(GIVEN, FOUND))
    groove = [row for row in rows if row["part"] == "groove B"]
    assert float(groove[0]["phi[deg]"]) == pytest.approx(180)
    assert float(groove[-1]["phi[deg]"]) == pytest.approx(270)
    middle = min(groove, key=lambda row: abs(float(row["phi[deg]"]) - 225))
    assert float(middle["R[mm]"]) == pytest.approx(130 - 50 - 12, abs=1e-3)
    assert float(middle["alpha[deg]"]) % 360 == pytest.approx(135, abs=0.05)


def test_points_for_a_machine_tool() -> None:
    given = replace(GIVEN, tolerance=1e-6)
    rows = rows_of(nc_table(given, FOUND))
    z = np.array([complex(float(row["X[mm]"]), float(row["Y[mm]"])) for row in rows])
    normal = np.array([complex(float(row["N_x"]), float(row["N_y"])) for row in rows])
    phi = np.array([float(row["phi[deg]"]) for row in rows])
    assert np.all(np.abs(np.abs(normal) - 1) < 1e-7)
    assert [row["part"] for row in rows[:1]] == ["flank A"]
    assert phi[0] == 0
    assert phi[-1] == 360
    assert z[0] == pytest.approx(z[-1], abs=2e-5)
    # from the profile along the normal stands the roller, whose place in the frame is known
    law = 10 * (phi / 90) ** 3 - 15 * (phi / 90) ** 4 + 6 * (phi / 90) ** 5
    on_a = np.array([row["part"] == "flank A" for row in rows])
    theta = np.radians(30 + 60 * law[on_a])
    roller = (130 - 50 * np.exp(-1j * theta)) * np.exp(-1j * np.radians(phi[on_a]))
    assert np.max(np.abs(z[on_a] + 12 * normal[on_a] - roller)) < 1e-4
    fine = rows_of(nc_table(replace(GIVEN, tolerance=1e-8), FOUND))
    assert len(fine) > 5 * len(rows)


def test_a_pointed_groove_has_its_pitch_curve() -> None:
    given = task(law=step_law("linear"), ratio=2.0, roller=None)
    found = solve_indexing(given)
    working = outlines(given, found)[1]
    for one, other in zip(working.pieces, (*working.pieces[1:], working.pieces[0]), strict=True):
        assert ends_of(one)[1] == pytest.approx(ends_of(other)[0], abs=1e-12)
    assert np.min(np.abs(working.polygon)) == pytest.approx(0.1 - 0.05, abs=1e-12)


@pytest.mark.slow
def test_drawings_have_equal_bytes() -> None:
    drawn = outlines(GIVEN, FOUND)
    assert svg(drawn, GIVEN.tolerance, "x") == svg(outlines(GIVEN, FOUND), GIVEN.tolerance, "x")
    pytest.importorskip("ezdxf")
    data = dxf(drawn).decode()
    assert all(f"\n{name}\n" in data for name in ("pitch curve", "working profile", "base circle"))
    assert data == dxf(outlines(GIVEN, FOUND)).decode()


def test_what_gives_no_profile_gives_no_file() -> None:
    given = task(law=StepLaw("2.9", 1.625), ratio=None, roller=None)
    with pytest.raises(UsageError, match="B alone"):
        nc_table(given, solve_indexing(given))
    with pytest.raises(UsageError, match="too fine"):
        outlines(replace(GIVEN, tolerance=1e-12), FOUND)


def test_documents_print_what_was_found() -> None:
    document = indexing_document(FOUND, "title")
    facts = {fact.label: fact for fact in document.facts}
    assert facts["tip of the lobe"].values["k_m"] == FOUND.cam.handover.part
    assert facts["lambda"].values["lambda_min"] == pytest.approx(2.25)
    assert document.table is not None
    assert "rho_A[mm]" in document.table.headers
    assert "xw_A[mm]" not in document.table.headers
    named = indexing_document(FOUND, "title", patterns=["xw_*", "source_B"])
    assert named.table is not None
    assert list(named.table.headers) == ["i", "xw_A[mm]", "xw_B[mm]", "source_B[deg]"]
    plain = indexing_document(FOUND, "title", everything=True)
    assert plain.table is not None
    assert list(plain.table.headers) == list(indexing_columns(FOUND))
    assert {fact.label for fact in indexing_summary(FOUND, "x").facts} == set(facts)
    alone = solve_indexing(task(law=StepLaw("2.9", 1.625), ratio=None, roller=None))
    assert indexing_document(alone, "x").table is None


@pytest.mark.slow
def test_pictures() -> None:
    from paper import on_sheet
    from paper import written as words_of

    from tmmcalc.cams.pictures.indexing import indexing_drawing
    from tmmcalc.report.drawing import written

    pointed = task(law=step_law("linear"), ratio=2.0, roller=None)
    one, other = (indexing_drawing(pointed, solve_indexing(pointed), radians(30)) for _ in range(2))
    assert written("svg", one) == written("svg", other)
    assert not on_sheet(one)
    said = " ".join(words_of(one))
    for word in ("front cam and its row", "load against the motion", "a loop", "O_2", "k_m"):
        assert word in said


def test_the_scheme_stands_where_the_law_has_it() -> None:
    from tmmcalc.cams.indexing.second import rows_of as rollers_at
    from tmmcalc.cams.indexing.second import turned
    from tmmcalc.cams.indexing.solve import drive_of

    drive, rests = drive_of(GIVEN, GIVEN.ratio), GIVEN.rests
    assert turned(drive, rests, radians(45)) == pytest.approx(radians(30))
    assert turned(drive, rests, radians(135)) == pytest.approx(radians(60))
    assert turned(drive, rests, radians(360)) == pytest.approx(radians(120))
    near, far = rollers_at(drive, rests, radians(135))  # in the dwell one of each row stands at +-30 deg
    place = 0.13 - 0.05 * np.exp(1j * radians(30))
    assert np.min(np.abs(near - place)) < 1e-15
    assert np.min(np.abs(far - np.conj(place))) < 1e-15


def test_a_law_without_profile_has_no_picture(tmp_path: Path) -> None:
    from drawing import drawn

    given = task(law=StepLaw("2.9", 1.625), ratio=None, roller=None)
    with pytest.raises(UsageError, match="no picture"):
        drawn("indexing", "cams", tmp_path / "a.svg", given, solve_indexing(given))
