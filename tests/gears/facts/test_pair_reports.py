"""The documents of pairs, measures and blocking contours, against the worked cases of the course and closed forms."""

from __future__ import annotations

import io
import json
import math
import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.facts.blocking import chosen_contours
from tmmcalc.gears.facts.blocking import document as blocking_document
from tmmcalc.gears.facts.blocking import summary as blocking_summary
from tmmcalc.gears.facts.measure import measure_document
from tmmcalc.gears.facts.pair import chosen_pairs
from tmmcalc.gears.facts.pair import document as pair_document
from tmmcalc.gears.facts.pair import summary as pair_summary
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.contours import Area, Blocking, ContourPoint, MissingPoints
from tmmcalc.gears.meshing.remeasure import remeasured
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pairs
from tmmcalc.gears.meshing.task import Measuring, PairsTask, PairTask
from tmmcalc.report.document import Document
from tmmcalc.report.plaintext import lines
from tmmcalc.report.render import render

FILE = Path(__file__).parents[2] / "cases" / "involute-geometry.json"
CASES = {case["id"]: case for case in json.loads(FILE.read_text())}
HELIX = math.radians(15)
BY_DISTANCE = PairTask((14, 17), 0.005, helix=HELIX, strategy="given_aw", distance=0.085, shifts=(0.6, None))
GIVEN = PairTask((14, 27), 0.005, helix=HELIX, strategy="given", shifts=(0.52, 0.31), face_width=0.04)
IMPOSSIBLE = PairTask((10, 12), 0.003, strategy="given", shifts=(-0.2, 0.1), refuse=False)
RING = PairTask((20, 60), 0.002, kind="internal", strategy="zero", wheels=("2'", "3"), name="2'-3")
RACK = PairTask((20, 0), 0.002, kind="rack", strategy="zero", name="drive")
MM = 1e-3


def solved(*tasks: PairTask) -> Pairs:
    return solve_pairs(PairsTask(tasks))


def rendered(document: Document, form: str) -> str:
    stream = io.StringIO()
    render(document, form, stream)
    return stream.getvalue()


def program(document: Document) -> dict[str, Any]:
    """What programs get, the same in both formats."""
    found: dict[str, Any] = json.loads(rendered(document, "json"))
    assert tomllib.loads(rendered(document, "toml")) == found
    return found


def text(document: Document) -> str:
    return "\n".join(lines(document))


def said(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def rows(document: Document) -> list[dict[str, Any]]:
    assert document.table is not None
    return [dict(zip(document.table.headers, row, strict=True)) for row in zip(*document.table.columns, strict=True)]


def part(document: Document, title: str) -> Document:
    (found,) = [each for each in document.parts if each.title == title]
    return found


class TestPair:
    def test_given_shifts(self) -> None:
        """IG-S02: the control example of program 1.11."""
        expected = CASES["IG-S02"]["expected"]
        document = pair_document(solved(GIVEN), "t")
        found = program(pair_document(solved(GIVEN), "t", everything=True))
        for key in ("a", "a_w"):
            assert found[f"{key}[m]"] == pytest.approx(expected[key] * MM, abs=1e-9)
        for key, name in (("eta", "eta"), ("y", "y"), ("dy", "delta_y"), ("x_sum", "x_sum")):
            assert found[key] == pytest.approx(expected[name], abs=1e-6)
        for key in ("alpha_t", "alpha_tw"):
            assert found[f"{key}[rad]"] == pytest.approx(math.radians(expected[f"{key}_deg"]), abs=1e-8)
        for number in ("1", "2"):
            wheel = found["wheels"][number]
            for key in ("r", "r_w", "r_a", "r_f", "r_b"):
                assert wheel[f"{key}[m]"] == pytest.approx(expected[f"{key}{number}"] * MM, abs=1e-9)
        degrees, minutes, seconds = expected["alpha_tw_dms"]
        assert said(document, "operating angle").endswith(f"= {degrees} deg {minutes}'{seconds:.2f}\"")
        assert said(document, "pair") == "z = 14/27, helical external, positive"

    def test_centre_distance(self) -> None:
        """IG-S04: programs 1.12 and 1.14."""
        expected = CASES["IG-S04"]["expected"]
        found = program(pair_document(solved(replace(BY_DISTANCE, face_width=0.04)), "t", everything=True))
        for key, name in (("g", "N1N2"), ("N1A2", "N1A2"), ("N2A1", "N2A1"), ("g_alpha", "g_alpha")):
            assert found[f"{key}[m]"] == pytest.approx(expected[name] * MM, abs=1e-9)
        for key in ("eps_alpha", "eps_beta", "eps_gamma", "x_sum"):
            assert found[key] == pytest.approx(expected[key], abs=1e-6)
        for key, name in (("theta_1", "theta1_at_A2"), ("theta_2", "theta2_at_A1"), ("lambda_P", "lambda_at_P")):
            assert found[key] == pytest.approx(expected[name], abs=1e-6)
        for number in ("1", "2"):
            wheel = found["wheels"][number]
            assert wheel["LN[m]"] == pytest.approx(expected[f"N{number}L{number}"] * MM, abs=1e-9)
            assert wheel["s_na[m]"] == pytest.approx(expected[f"s_a{number}_normal"] * MM, abs=1e-9)
        assert found["verdict"] == "warn"
        assert [check["text"] for check in found["checks"] if check["verdict"] != "ok"] == [
            "transverse contact ratio 1.112 below 1.2"
        ]

    def test_people_read_millimetres_and_degrees(self) -> None:
        document = pair_document(solved(BY_DISTANCE), "t")
        table = {row["symbol"]: row for row in rows(document)}
        assert table["r_a"]["wheel 1[mm]"] == pytest.approx(CASES["IG-S04"]["expected"]["r_a1"], abs=1e-6)
        assert "a_w = 85 mm" in said(document, "centre distance")
        assert said(document, "choice of shifts") == "centre distance as given, x1 as given"
        assert "no face width is given for eps_beta" in said(document, "contact ratio")
        checks = {(row["check"], row["wheel"]): row for row in rows(part(document, "checks"))}
        angle = checks["pressure angle, deg", ""]
        assert (angle["value"], angle["limit"], angle["margin"]) == (27.9568, 30.0, 2.0432)
        undercut = checks["undercut", "1"]
        assert undercut["margin[mm]"] == f"{5 * undercut['margin']:.3f}"
        assert checks["contact ratio", ""]["verdict"] == "warning"
        assert checks["pressure", ""]["verdict"] == "not judged"
        assert max(map(len, lines(document))) <= 80

    def test_sliding_is_the_table_for_programs(self) -> None:
        table = rows(pair_document(solved(BY_DISTANCE), "t", everything=True))
        at_pitch = min(table, key=lambda row: abs(row["s[m]"]))
        assert at_pitch["s[m]"] == pytest.approx(0, abs=1e-12)
        assert (at_pitch["theta1"], at_pitch["theta2"]) == (pytest.approx(0, abs=1e-9), pytest.approx(0, abs=1e-9))
        active = [row["rho1[m]"] for row in table if row["active"] == "yes"]
        expected = CASES["IG-S04"]["expected"]
        assert min(active) == pytest.approx(expected["N1A2"] * MM, abs=1e-9)
        assert max(active) - min(active) == pytest.approx(expected["g_alpha"] * MM, abs=1e-9)

    def test_a_pair_that_cannot_work(self) -> None:
        document = pair_document(solved(IMPOSSIBLE), "t")
        assert said(document, "verdict") == "cannot work: 5 of 13 conditions fail"
        assert document.notes[0].startswith("warning: cannot work: ")
        outside = document.notes[-1]
        assert outside.startswith("warning: the shifts lie outside the blocking contour: undercut of wheel 1")
        x1, x2 = (float(word.strip(",").split(" = ")[1]) for word in outside.partition("are ")[2].split(", "))
        assert not solved(replace(IMPOSSIBLE, shifts=(x1 + 1e-3, x2 + 1e-3))).pairs[0].broken
        assert "of the whole flanks" in said(document, "contact ratio")
        assert "touch from N1K" in said(document, "line of action")

    @pytest.mark.parametrize(
        ("shifts", "word"),
        [((0.2, 0.1), "positive"), ((0.3, -0.4), "negative"), ((0.25, -0.25), "equally shifted"), ((0.0, 0.0), "zero")],
    )
    def test_classes(self, shifts: tuple[float, float], word: str) -> None:
        document = pair_document(solved(PairTask((30, 40), 0.002, strategy="given", shifts=shifts)), "t")
        assert said(document, "pair") == f"z = 30/40, spur external, {word}"

    def test_the_rule_of_seventeen_teeth(self) -> None:
        """Of standard spur wheels only: 13 teeth, 0.2353 in place of 0.2396."""
        task = PairTask((13, 34), 0.005, strategy="given", shifts=(0.3, 0.0))
        exact = [1 - z * math.sin(math.radians(20)) ** 2 / 2 for z in task.teeth]
        assert said(pair_document(solved(task), "t"), "no undercut from").splitlines() == [
            f"x_min1 = {exact[0]:.7g}, x_min2 = {exact[1]:.7g}",
            "about (17 - z)/17 = 0.2353 and -1 by the textbook",
            f"at these shifts from z_min1 = {0.7 * 34.194407 / 2:.5g}, z_min2 = 17.097",
        ]
        assert "textbook" not in said(pair_document(solved(GIVEN), "t"), "no undercut from")

    def test_a_ring(self) -> None:
        """The contact ratio of a plain ring by its closed form; wheels have the names of the train."""
        document = pair_document(solved(RING), "t")
        found = program(pair_document(solved(RING), "t", everything=True))
        assert found["a[m]"] == pytest.approx(0.04, rel=1e-14)
        n2p = found["wheels"]["3"]["r_b[m]"] * math.tan(math.radians(20))
        assert found["N2P[m]"] == pytest.approx(n2p, rel=1e-12)
        assert found["N2P[m]"] - found["N1P[m]"] == pytest.approx(found["g[m]"], rel=1e-12)
        assert found["g_alpha[m]"] == pytest.approx(
            found["N2A1[m]"] - found["N2P[m]"] + found["N1P[m]"] - found["N1A2[m]"]
        )
        assert "LN[m]" not in found["wheels"]["3"]
        assert "index 1: wheel 2', 2: wheel 3" in said(document, "teeth")
        assert document.table is not None
        assert document.table.headers[2:] == ["wheel 2'[mm]", "wheel 3 (ring)[mm]"]
        assert any(note.startswith("warning: specific sliding of wheel 2'") for note in document.notes)

    def test_a_rack(self) -> None:
        document = pair_document(solved(RACK), "t")
        found = program(pair_document(solved(RACK), "t", everything=True))
        assert said(document, "centre distance").startswith("r + x m = 20 mm")
        assert "x_2" not in found
        assert list(found["wheels"]) == ["1"]
        assert {check.get("wheel") for check in found["checks"]} == {None, "1", "rack"}

    def test_several_pairs(self) -> None:
        result = solved(BY_DISTANCE, RING, RACK, BY_DISTANCE)
        found = program(pair_document(result, "t", everything=True))
        names = ["z = 14/17, pair 1", "2'-3: z = 20/60 (ring)", "drive: z = 20/rack", "z = 14/17, pair 4"]
        assert [part.title for part in pair_document(result, "t").parts] == names
        assert set(names) < set(found)
        assert set(found["columns"]["pair"]) == {"z = 14/17", "2'-3", "drive"}
        summary = pair_summary(result, "pair")
        assert [row["pair"] for row in rows(summary)] == names
        assert any(note.startswith("warning: drive: ") for note in summary.notes)
        alone = chosen_pairs(result, "2'-3")
        assert [pair.task for pair in alone.pairs] == [RING]
        assert chosen_pairs(result, None) == result
        with pytest.raises(UsageError, match="no pair is called 'drove'") as fault:
            chosen_pairs(result, "drove")
        assert fault.value.remedy == "pairs: 1, 2'-3, drive, 4"

    def test_the_summary_of_one_pair(self) -> None:
        result = replace(solved(BY_DISTANCE), train="unfolded: 14/17", remarks=("the module is a guess",))
        summary = pair_summary(result, "pair")
        assert said(summary, "meshes of") == "unfolded: 14/17"
        assert summary.notes[0] == "note: the module is a guess"
        assert not summary.parts
        assert len(lines_of(summary)) < len(lines_of(pair_document(result, "pair")))


def lines_of(document: Document) -> list[str]:
    return list(lines(document))


class TestMeasure:
    def test_the_wheel_of_the_course(self) -> None:
        """IG-S12: span, balls of 8.5 mm, constant chord, chords."""
        expected = CASES["IG-S12"]["expected"]
        result = remeasured(solved(GIVEN), ball=0.0085)
        found = program(measure_document(result, "t", everything=True))["wheel 2"]
        span = expected["span"]
        assert (found["z_w"], found["W_exact"]) == (span["z_w"], True)
        for key, name in (("W", "W"), ("p_bn", "p_bn"), ("s_bn", "s_bn"), ("b_min", "b_min_exact")):
            assert found[f"{key}[m]"] == pytest.approx(span[name] * MM, abs=1e-9)
        for key, name in (("W_star", "W_star"), ("W_star_exact", "W_star_exact"), ("W_starstar", "W_starstar")):
            assert found[f"{key}[m]"] == pytest.approx(span[name] * MM, abs=1e-9)
        assert found["W_lowest[m]"] == pytest.approx(span["form_rho_LN"] * 2 * MM / math.cos(base_helix()), abs=1e-9)
        assert found["M[m]"] == pytest.approx(expected["balls_D_8_5"]["M"] * MM, abs=1e-9)
        assert found["s_c[m]"] == pytest.approx(expected["constant_chord"] * MM, abs=1e-9)
        assert found["h_c[m]"] == pytest.approx(expected["constant_chord_height"] * MM, abs=1e-9)
        chords = {round(row["r[m]"] / MM, 6): row for row in found["chords"]}
        for row in expected["at_radius"][1:]:
            assert chords[row["r_y"]]["chord[m]"] == pytest.approx(row["chord_s_y"] * MM, abs=1e-9)
            assert chords[row["r_y"]]["height[m]"] == pytest.approx(row["height_h_ay"] * MM, abs=1e-9)

    def test_what_lies_beneath_the_involute_is_a_warning(self) -> None:
        """IG-S03: with a face of 10 mm the textbook's rule gives a span that cannot be measured."""
        case = CASES["IG-S03"]["expected"]["b10"]
        task = replace(GIVEN, shifts=(0.52, 0.32), face_width=0.01)
        (wheel,) = measure_document(solved(task), "t", wheel="2").parts
        assert f"W = {case['W']:.5f} mm over z_w = {case['z_w']} teeth"[:11] in said(wheel, "span")
        assert "not valid: beneath the involute; admitted by the textbook's rule" in said(wheel, "span")
        assert wheel.notes[0].startswith("warning: span over 2 teeth")
        exact = replace(task, measuring=Measuring(rule="exact"))
        (wheel,) = measure_document(solved(exact), "t", wheel="2").parts
        assert "not valid: beneath the active flank; not admitted by the textbook's rule" in said(wheel, "span")
        assert wheel.notes[0].startswith("warning: span over 3 teeth: the plates touch beneath the usable involute")

    def test_a_span_as_asked(self) -> None:
        """Every further tooth adds one base pitch; past the tip nothing is touched."""
        result = solved(GIVEN)
        values = [
            program(measure_document(remeasured(result, teeth=k), "t", everything=True))["wheel 1"] for k in (2, 3, 7)
        ]
        pitch = 0.005 * math.pi * math.cos(math.radians(20))
        assert np.diff([each["W[m]"] for each in values]) == pytest.approx([pitch, 4 * pitch], rel=1e-12)
        assert [each["z_w"] for each in values] == [2, 3, 7]
        assert [each["W_exact"] for each in values] == [True, True, False]
        (wheel,) = measure_document(remeasured(result, teeth=7), "t", wheel="1").parts
        assert "not valid: beyond the tip; not admitted" in said(wheel, "span")
        (chosen,) = [row for row in rows(wheel) if row["remark"].startswith("chosen")]
        assert (chosen["z_w"], chosen["exact"], chosen["remark"]) == (7, False, "chosen; beyond the tip")

    def test_measuring_again_changes_nothing_else(self) -> None:
        """Also of undercut wheels and rings."""
        result = solved(GIVEN, IMPOSSIBLE, RING, RACK)
        again = remeasured(result)
        for before, after in zip(result.pairs, again.pairs, strict=True):
            for one, two in zip(before.measures, after.measures, strict=True):
                assert (one.span_teeth, one.spans, one.remarks) == (two.span_teeth, two.spans, two.remarks)
                assert [row.chord for row in one.chords] == pytest.approx([row.chord for row in two.chords], rel=1e-13)
                assert one.balls is not None
                assert two.balls is not None
                assert one.balls.size == pytest.approx(two.balls.size, rel=1e-13)
                assert one.span_lowest == pytest.approx(two.span_lowest, rel=1e-9)

    def test_balls_that_do_not_fit(self) -> None:
        small, large = (
            measure_document(remeasured(solved(GIVEN), ball=ball), "t", wheel="1").parts[0] for ball in (0.003, 0.024)
        )
        assert said(small, "over two balls") == "none can be measured"
        assert small.notes[0].startswith("warning: balls of 3 mm do not stand in the space")
        assert "not valid: they do not touch the usable involute" in said(large, "over two balls")
        with pytest.raises(UsageError, match="cannot be measured over"):
            remeasured(solved(GIVEN), ball=-0.001)

    def test_rings_and_names(self) -> None:
        document = measure_document(solved(RING, RACK), "t")
        assert [each.title for each in document.parts] == [
            "2'-3: z = 20/60 (ring), wheel 2'",
            "2'-3: z = 20/60 (ring), wheel 3",
            "drive: z = 20/rack, wheel 1",
        ]
        ring = document.parts[1]
        assert said(ring, "span").startswith("a ring has none")
        assert said(ring, "between two balls").startswith("M = ")
        assert ring.table is None
        assert max(map(len, lines(document))) <= 80
        with pytest.raises(UsageError, match="no wheel is called '4'"):
            measure_document(solved(RING, RACK), "t", wheel="4")

    def test_all_spans_are_the_table_for_programs(self) -> None:
        result = solved(GIVEN)
        document = measure_document(result, "t", everything=True)
        table = rows(document)
        assert {row["wheel"] for row in table} == {"1", "2"}
        assert [row["chosen"] for row in table].count(True) == 2
        assert rendered(document, "csv").startswith("pair,wheel,z_w,W[m],r[m],b_min[m],exact,textbook,chosen\n")


def base_helix() -> float:
    return math.asin(math.sin(HELIX) * math.cos(math.radians(20)))


def point(name: str, x1: float, x2: float, **more: Any) -> ContourPoint:
    inside = {"strict": True, "tolerated": True, **more}
    return ContourPoint(name, f"what {name} is", x1, x2, 1.2, (0.3, 0.4), (-1.5, -1.25), (2.5, 2.4), 0.0822, **inside)


Scene = Callable[..., Blocking]


@pytest.fixture(scope="module")
def scene() -> Scene:
    """The spur pair 14/17 with the contours of IG-S09, the rest as written here."""
    (spur,) = solve_blocking(solved(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522)))).pairs

    def blocking(**more: Any) -> Blocking:
        pair = replace(
            spur,
            name="1-2",
            points=(point("chosen", 0.6, 0.522), point("equal strength", 0.5, 0.7)),
            missing=(MissingPoints(("D",), "equal sliding needs a smaller contact ratio"),),
            margins={"undercut1": 0.418844, "contact_ratio": 0.143934, "interference1": 0.65, "tolerated1": 0.66},
            low=0.18116,
            high=0.81149,
            ends=("undercut1", "contact_ratio"),
        )
        return Blocking((replace(pair, **more),), ("pair 2-3 is internal: it has none",))

    return blocking


class TestAtTheLimitOfUndercut:
    """Point E of many pairs is a corner of the limit of undercut: contact begins on the base circle of wheel 1."""

    @pytest.mark.parametrize("teeth", [(25, 62), (18, 60)])
    def test_sliding_is_unbounded_and_told_so(self, teeth: tuple[int, int]) -> None:
        pair = solved(PairTask(teeth, 0.005, strategy="zero"))
        found = solve_blocking(pair)
        (told,) = (row for row in rows(part(blocking_document(found, "t"), "points")) if row[""] == "theta_1")
        (ratio,) = (row for row in rows(part(blocking_document(found, "t"), "points")) if row[""] == "eps_alpha")
        assert (told["E"], told["D"]) == ("unbounded", pytest.approx(-0.7, abs=0.2))
        assert ratio["E"] == pytest.approx(found.pairs[0].strict.best_contact_ratio, abs=1e-3)
        points = program(blocking_document(found, "t", everything=True))["points"]
        assert ("theta_1" in points["E"], "theta_2" in points["E"]) == (False, True)


class TestBlocking:
    def test_corners_and_areas(self, scene: Scene) -> None:
        """IG-S09."""
        expected = CASES["IG-S09"]["expected"]
        document = blocking_document(scene(), "t")
        corners = rows(part(document, "corners"))
        for kind, key in (("strict", "strict_vertices"), ("tolerated", "allowed_undercut_vertices")):
            found = sorted((row["x_1"], row["x_2"]) for row in corners if row["contour"] == kind)
            wanted = sorted((vertex["x1"], vertex["x2"]) for vertex in expected[key])
            assert np.array(found) == pytest.approx(np.array(wanted), abs=2e-4)
        assert {row["between"] for row in corners} > {
            "limit of undercut of wheel 1; limit of undercut of wheel 2",
            "tip of wheel 2 cuts into the fillet of wheel 1; least contact ratio",
        }
        assert said(document, "strict contour").startswith("no undercut: area 0.96")
        assert "eps_alpha up to 1.4182" in said(document, "strict contour")
        assert max(map(len, lines(document))) <= 80
        apart = replace(scene().pairs[0].strict, pieces=(replace(scene().pairs[0].tolerated.main, area=0.031),) * 2)
        assert "\nand 2 pieces apart from it, area 0.062" in said(
            blocking_summary(scene(strict=apart), "t"), "strict contour"
        )

    def test_where_the_choice_stands(self, scene: Scene) -> None:
        document = blocking_summary(scene(), "blocking")
        assert said(document, "chosen shifts") == "x_1 = 0.6, x_2 = 0.522: within the strict contour"
        assert said(document, "margins").splitlines() == [
            "least contact ratio: 0.1439",
            "limit of undercut of wheel 1: 0.4188",
            "tip of wheel 2 cuts into the fillet of wheel 1: 0.65",
        ]
        assert said(document, "x_1 at this sum").splitlines() == [
            "from 0.18116 (limit of undercut of wheel 1)",
            "to 0.81149 (least contact ratio)",
        ]
        assert document.notes == (
            "note: pair 2-3 is internal: it has none",
            "note: D: equal sliding needs a smaller contact ratio",
        )

    def test_outside(self, scene: Scene) -> None:
        outside = scene(points=(point("chosen", -1.0, 0.0, strict=False, tolerated=False),), low=None, high=None)
        document = blocking_summary(outside, "t")
        assert "warning: the chosen shifts lie outside the blocking contour" in document.notes
        assert said(document, "x_1 at this sum") == "none is admissible"
        cut = scene(margins={"undercut1": -0.1, "interference1": 0.65, "tolerated1": 0.3})
        assert said(blocking_summary(cut, "t"), "margins").splitlines() == [
            "limit of undercut of wheel 1: -0.1",
            "undercut of wheel 1 reaches the active flank: 0.3",
        ]
        undercut = scene(points=(point("chosen", 0.1, 0.0, strict=False),))
        assert "tolerated contour only" in said(blocking_summary(undercut, "t"), "chosen shifts")
        assert any(
            note.startswith("note: the chosen shifts lie outside the strict")
            for note in blocking_summary(undercut, "t").notes
        )

    def test_nothing_admissible(self, scene: Scene) -> None:
        none = Area(True, None, "no shifts give a mesh without undercut", (), (1,), 0.0)
        document = blocking_document(scene(strict=none, points=(), margins={}), "t")
        assert said(document, "strict contour") == "no undercut: none\nno shifts give a mesh without undercut"
        assert any("parts with tip 2 inside its reference circle are not outlined" in n for n in document.notes)
        assert [each.title for each in document.parts] == ["corners"]
        assert {row["contour"] for row in rows(document.parts[0])} == {"tolerated"}

    def test_points(self, scene: Scene) -> None:
        points = part(blocking_document(scene(), "t"), "points")
        assert said(points, "equal strength") == "what equal strength is"
        table = {row[""]: row for row in rows(points)}
        assert table["a_w, mm"]["chosen"] == pytest.approx(82.2)
        assert table["x_2"]["equal Y_F"] == 0.7
        assert table["strict"]["chosen"] is True
        deep = scene(points=(replace(point("chosen", 0.1, 0.2), sliding=(0.0, -9.5)),))
        (column,) = rows(part(blocking_document(deep, "t"), "points"))[5:6]
        assert (column[""], column["chosen"]) == ("theta_1", "-")
        found = program(blocking_document(deep, "t", everything=True))
        assert "theta_1" not in found["points"]["chosen"]
        assert found["points"]["chosen"]["theta_2"] == -9.5

    def test_by_name(self, scene: Scene) -> None:
        assert chosen_contours(scene(), "1-2") == scene()
        with pytest.raises(UsageError, match="no pair is called '3-4'"):
            chosen_contours(scene(), "3-4")
        two = replace(scene(), pairs=scene().pairs * 2)
        assert [each.title for each in blocking_document(two, "t").parts] == [
            "1-2: z = 14/17, pair 1",
            "1-2: z = 14/17, pair 2",
        ]
