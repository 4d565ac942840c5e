"""The train stage against the worked cases of the textbook, through specs; files; what an empty search says."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.advice import removals
from tmmcalc.gears.columns import set_columns
from tmmcalc.gears.pictures.placed import placed
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.stepping import found_by_textbook, stepped
from tmmcalc.gears.tables.tasks.train import to_train
from tmmcalc.gears.trains import Trains, Variant
from tmmcalc.pipeline.runner import run

CASES: dict[str, Any] = {
    case["id"]: case for case in json.loads((Path(__file__).parents[2] / "cases" / "gear-trains.json").read_text())
}
ABSOLUTE = 'tolerance_kind = "absolute"\n'
COAXIAL = f'layout = "coaxial"\nratio = "8.15"\ntolerance = "0.08"\n{ABSOLUTE}module_ratios = [[2, 3]]\n'
AI = f'layout = "AI"\nratio = "31.29"\ntolerance = "0.5"\n{ABSOLUTE}module_ratios = [[4, 7]]\n'
AIBAR = f'layout = "AIbar"\nratio = "7.29"\ntolerance = "0.1"\n{ABSOLUTE}'
UNFOLDED = 'layout = "unfolded2"\nratio = "8.15"\nz_min = 16\nz_pinion_max = 22\n'
BAND = "constraints = {{ diameter_band = 0.03{} }}\n"


def trains(text: str) -> Trains:
    result: Trains = run(tmmcalc.parse_spec(f"[train]\n{text}"), target="train").results["train"]
    return result


def variant(text: str) -> Variant:
    (found,) = trains(text).variants
    return found


def rows(found: Variant) -> list[list[int]]:
    listed: list[list[int]] = found.sets.teeth.tolist()
    return listed


def coprime(found: Variant) -> int:
    return int(np.count_nonzero(set_columns(found)["coprime"]))


def expected(case: str) -> dict[str, Any]:
    part: dict[str, Any] = CASES[case]["expected"]
    return part


def test_unfolded_by_the_textbook() -> None:
    """GT-S01, table 4.2."""
    found = variant(UNFOLDED + 'method = "textbook"\nconstraints = { diameter_band = false }\n')
    table = [[z, first, z, second] for z, first, second in CASES["GT-S01"]["printed"]["rows"]]
    assert rows(found) == table
    errors = [row["rel_error"] for row in expected("GT-S01")["rows"] if row["accepted"]]
    assert set_columns(found)["error[%]"] == pytest.approx([100 * error for error in errors], abs=1e-3)


def test_unfolded_with_all_wheels_alike() -> None:
    """GT-S24: the complete search holds the textbook's rows and marks them."""
    case = expected("GT-S24")
    equal = variant(UNFOLDED + BAND.format(", equal_pinions = true"))
    assert rows(equal) == case["equal_pinions_solutions"]
    assert coprime(equal) == case["equal_pinions_coprime_count"]
    free = variant(UNFOLDED + BAND.format(""))
    assert (free.synthesis.count, coprime(free)) == (
        case["independent_pinions_count"],
        case["independent_pinions_coprime_count"],
    )
    assert free.textbook is not None
    marked = free.sets.teeth[free.textbook][:, 0].tolist()
    assert marked == [row[0] for row in CASES["GT-S01"]["printed"]["rows"]]
    assert "slight undercut" in free.request.remarks[0]


def test_coaxial_with_one_layshaft() -> None:
    """GT-S04, table 4.4."""
    case, found = expected("GT-S04"), variant(COAXIAL + "z_max = 100\n")
    assert (found.synthesis.count, coprime(found)) == (case["full_search_count"], case["full_search_coprime_count"])
    columns = set_columns(found)
    listed = [row for row, e in zip(rows(found), columns["e"], strict=True) if e <= 33]
    assert sorted(listed) == sorted(row["z"] for row in case["solutions_up_to_e_max"])
    ratio = {tuple(row["z"]): row["U"] for row in case["solutions_up_to_e_max"]}
    for row, u in zip(rows(found), columns["u"], strict=True):
        assert u == pytest.approx(ratio.get(tuple(row), u), abs=1e-5)


@pytest.mark.parametrize("layout", ['layout = "coaxial"\n', 'layout = "AA"\nratio_kind = "u"\n'])
def test_three_branches(layout: str) -> None:
    """GT-S09: layshafts and planets of AA are one problem."""
    case = expected("GT-S09")
    found = variant(layout + COAXIAL.partition("\n")[2] + "planets = 3\nz_max = 120\n")
    assert (found.synthesis.count, coprime(found)) == (case["full_count"], case["coprime_count"])
    assert rows(found)[:8] == case["first_eight_by_sum"]


def test_single_planets() -> None:
    """GT-S06, table 4.8; suns beyond 40 teeth are not counted there."""
    case, found = expected("GT-S06"), variant(AIBAR)
    assert [row for row in rows(found) if row[0] <= 26] == [row["z"] for row in case["solutions"]]
    assert len([row for row in rows(found) if row[0] <= 40]) == case["full_count"]


def test_double_planets() -> None:
    """GT-S08, table 4.9; the count is that of the textbook's loop over e up to 25."""
    case, found = expected("GT-S08"), variant(AI)
    columns = set_columns(found)
    listed = [row for row, e in zip(rows(found), columns["e"], strict=True) if e <= 24]
    assert sorted(listed) == sorted(row["z"] for row in case["solutions_up_to_e_max"])
    assert found.synthesis.count == case["full_count"]
    assert coprime(found) == 0


def test_limits_of_the_tolerance_are_kept() -> None:
    """GT-S22: 122/20 = 6.1 exactly, which binary floats lose."""
    head = f'layout = "AIbar"\nratio = "6.2"\nratio_kind = "u"\ntolerance = "0.1"\n{ABSOLUTE}planets = 2\n'
    found = variant(head)
    assert [row for row in rows(found) if row[0] == 20] == expected("GT-S22")["solutions"]


def test_pairs_of_planets() -> None:
    """GT-S21 has limits of its own for each wheel: the sets within them are chosen from all."""
    case = expected("GT-S21")
    head = f'layout = "2A-AA"\nratio = 5\ntolerance = "0.05"\n{ABSOLUTE}planets = 3\nz_max = 100\n'
    found = variant(head)
    z1, z2, z3, _ = found.sets.teeth.T
    inside = (z1 >= 18) & (z1 <= 24) & (z2 <= 60) & (z3 <= 30)
    assert np.count_nonzero(inside) == case["count"]
    flat = variant(head + "constraints = { mesh_angle_max = false }\n").sets.teeth.T
    within = (flat[0] >= 18) & (flat[0] <= 24) & (flat[1] <= 60) & (flat[2] <= 30)
    assert np.count_nonzero(within) == case["count_equal_angle"]
    (at,) = np.flatnonzero((found.sets.teeth == CASES["GT-S21"]["inputs"]["closure_example"]).all(axis=1))
    angle = case["closure_example"]["alpha_w12_deg"]
    assert set_columns(found)["alpha_max[deg]"][at] == pytest.approx(angle, abs=1e-4)


def test_gap_of_pairs_of_planets_is_that_of_the_picture() -> None:
    """At the operating centre distances, of all neighbours; by hand: 138 teeth raise 18 + 2 24 + 66 = 132."""
    found = variant('layout = "2A-AA"\nratio = 5\nz_max = 80\n')
    gaps, angles = set_columns(found)["gap[module]"], set_columns(found)["alpha_max[deg]"]
    for row in {0, len(gaps) // 2, len(gaps) - 1, int(angles.argmax()), int(angles.argmin())}:
        drawn = placed(found.sets, row).gap
        assert drawn is not None
        assert gaps[row] == pytest.approx(drawn.size, abs=1e-9)
    (at,) = np.flatnonzero((found.sets.teeth == [18, 24, 66, 72]).all(axis=1))
    assert gaps[at] == pytest.approx(42 * 138 / 132 * np.sqrt(0.75) - 26, abs=1e-12)


TASKS = [
    COAXIAL,
    COAXIAL + "planets = 3\n",
    COAXIAL.replace("[[2, 3]]", "[[1, 1], [4, 7], [2, 5], [5, 8]]"),
    AI,
    AI.replace("[[4, 7]]", "[[1, 1], [2, 3]]"),
    AI.replace("AI", "AA").replace("31.29", "-6.4"),
    AIBAR,
    UNFOLDED,
    'layout = "unfolded3"\nratio = 30\n',
]


@sparing("text", TASKS, ids=range(len(TASKS)), every=3)
def test_marks_are_what_the_stepping_finds(text: str) -> None:
    """The mark is a formula; the program that steps is the truth."""
    (request,) = to_train(tmmcalc.parse_spec(f"[train]\n{text}"))
    sets = synthesise(request.task).sets
    mask = found_by_textbook(request.task, sets)
    assert mask is not None
    truth = stepped(request.task).sets
    stepping = {tuple(row) for row in np.concatenate([truth.teeth, truth.modules], axis=1).tolist()}
    keys = np.concatenate([sets.teeth, sets.modules], axis=1).tolist()
    assert mask.tolist() == [tuple(key) in stepping for key in keys]
    assert mask.any()


def test_removals_add_up() -> None:
    found = variant(AI)
    steps = removals(found)
    assert steps[0][2] == found.synthesis.candidates
    assert steps[-1][2] - steps[-1][1] == found.synthesis.count
    assert [name for name, _, _ in steps] == ["coaxiality", "ratio", "assembly", "adjacency"]


def test_files_give_back_what_was_computed(tmp_path: Path) -> None:
    spec = tmmcalc.parse_spec(f"[train]\n{AIBAR}planets = [3, 4]\nmodule = 0.002\nconstraints = {{ coprime = true }}\n")
    first = run(spec, out=tmp_path)
    again = run(spec, out=tmp_path)
    assert [event.kind for event in again.events if event.stage == "train"] == ["loaded"]
    for one, other in zip(first.results["train"].variants, again.results["train"].variants, strict=True):
        assert one.request == other.request
        assert np.array_equal(one.sets.teeth, other.sets.teeth)
        assert one.synthesis.removed == other.synthesis.removed
        assert one.relaxations == other.relaxations
    lines = (tmp_path / "train.csv").read_text().splitlines()
    assert lines[0].startswith("layout,planets,z_1,z_2,z_3,i_1H,error[%],coprime,textbook,")
    assert len(lines) == 1 + first.results["train"].variants[0].synthesis.count


def test_bounded_memory_keeps_the_smallest_and_counts_all() -> None:
    whole, held = variant(COAXIAL), variant(COAXIAL + "keep = 7\n")
    assert held.synthesis.count == whole.synthesis.count
    assert rows(held) == rows(whole)[:7]


EMPTY = {
    "tolerance": AI + "z_max = 100\n",
    "z_max": AI + "z_max = 100\n",
    "planets": AIBAR + "planets = 4\n",
    "mesh_angle_max": AIBAR + "planets = 4\n",
    "coprime": AI + "constraints = { coprime = true }\n",
    "adjacency_gap": AIBAR + "sum_max = 90\nconstraints = { adjacency_gap = 15 }\n",
    "ring_difference": AIBAR + "constraints = { ring_difference = 100 }\nz_max = 60\n",
    "sum_max": COAXIAL + "sum_max = 60\n",
    "stage_ratio_max": UNFOLDED + "constraints = { stage_ratio_max = 2.5 }\n",
    "diameter_band": UNFOLDED.replace("22", "18") + "constraints = { diameter_band = 0.0001 }\n",
    "envelope": COAXIAL + "planets = 3\nmodule = 0.002\nconstraints = { envelope = 0.2 }\n",
    "centre_distance": COAXIAL + 'module = 0.002\nconstraints = { centre_distance = ["40 mm", "50 mm"] }\n',
}


@sparing("key", EMPTY, every=4)
def test_what_would_help_does(key: str) -> None:
    """Each advice is followed: the spec with the changed limit has the set that was promised."""
    with pytest.raises(NoSolutionError) as caught:
        variant(EMPTY[key])
    assert caught.value.exit_code == 3
    assert "removed the last" in caught.value.message
    (line,) = (line for line in caught.value.remedy.split("\n  -> ") if line.startswith(key))
    promised = [int(z) for z in re.findall(r"gives ([0-9/]+)", line)[0].split("/")]
    found = variant(followed(EMPTY[key], key, line))
    assert promised in rows(found)


def followed(text: str, key: str, line: str) -> str:
    """The spec with the change that a line of advice names."""
    change = line.partition(" gives ")[0]
    value = change.partition("->" if "->" in change else "=")[2].partition("(")[0].strip()
    if key in ("envelope", "centre_distance"):
        value = f'"{value}"'
    if key == "centre_distance":
        value = f'["40 mm", {value}]'
    if key == "tolerance":
        value = f'"{value}"'
    if re.search(rf"\b{key} = ", text):
        return re.sub(rf'\b{key} = (\[.*?\]|"[^"]*"|[\w.]+)', lambda _: f"{key} = {value}", text)
    if key in ("mesh_angle_max",):
        return f"{text}constraints = {{ {key} = {value} }}\n"
    return f"{text}{key} = {value}\n"


def test_ratios_of_the_layout_are_said_where_the_one_asked_for_is_none() -> None:
    with pytest.raises(NoSolutionError, match=r"i_1H = 2\.22973 is the least that everything else admits"):
        variant('layout = "AIbar"\nratio = 1.6\n')
    with pytest.raises(NoSolutionError, match=r"u = [\d.]+ is the greatest that everything else admits"):
        variant('layout = "unfolded2"\nratio = 50\n')


def test_by_name_no_advice_is_sought() -> None:
    spec = tmmcalc.parse_spec('[train]\nlayout = "unfolded2"\nratio = 50\n')
    with pytest.raises(NoSolutionError, match="no tooth set") as found:
        run(spec, target="train", by_name=True)
    assert "admits" not in found.value.message
    assert found.value.remedy == "tmmcalc run tells what would help"
    three, four = run(tmmcalc.parse_spec(f"[train]\n{AIBAR}planets = [3, 4]\n"), by_name=True).results["train"].variants
    assert three.synthesis.count
    assert four.relaxations == ()


def test_one_empty_variant_of_several_stops_nothing() -> None:
    three, four = trains(AIBAR + "planets = [3, 4]\n").variants
    assert three.synthesis.count
    assert not four.synthesis.count
    assert four.relaxations
