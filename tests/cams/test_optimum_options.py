"""The design game where what is asked has no solution: the table is given, all else is of the lowest option."""

from dataclasses import replace

import numpy as np
import pytest

from cams.optimum_scene import flat_task, roller_task
from tmmcalc.cams.facts.cam_optimum import document as optimum_document
from tmmcalc.cams.facts.cam_optimum import summary as optimum_summary
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum.options import with_law
from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.task import Spring
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError

pytestmark = pytest.mark.slow

ROLLER, FLAT = Follower("translating", 0.05), Follower("flat", 0.05)
CONTACTS = (("bronze", 1.1e7), ("steel", 4e8), ("hard steel", 6e8))


def soft(**asked):
    """Case s16 with a contact stress that no size keeps."""
    task = roller_task(**asked)
    return replace(task, requirements=replace(task.requirements, contact=1e7))


def facts(document):
    return {fact.label: fact.text for fact in document.facts}


def test_the_table_is_given_and_the_lowest_option_shown() -> None:
    result = solve_optimum(soft(contacts=CONTACTS), ROLLER)
    asked, bronze, steel, hard = result.options
    assert asked.changes == ()
    assert asked.refused == result.refused
    assert "contact stress" in asked.refused
    assert bronze.refused
    assert not steel.refused
    assert result.shown == hard.changes
    assert hard.least < steel.least
    alone = roller_task()
    alone = solve_optimum(replace(alone, requirements=replace(alone.requirements, contact=6e8)), ROLLER)
    assert result.least == alone.least
    assert result.chosen == alone.chosen
    assert hard.least == pytest.approx(alone.least.height, abs=1e-7)
    assert np.array_equal(result.start, alone.start)
    assert result.notes[0].startswith("warning: as asked there is no mechanism: constraint")
    again = from_record(CamOptimum, to_record(result))
    assert (again.refused, again.shown, again.options) == (result.refused, result.shown, result.options)


def test_report_and_picture_say_so(tmp_path) -> None:
    task = soft(contacts=CONTACTS)
    result = solve_optimum(task, ROLLER)
    for document in (optimum_document(result, ""), optimum_summary(result, "")):
        assert facts(document)["as asked"].startswith("no solution: constraint")
        assert facts(document)["option shown"] == "contact hard steel (600 MPa)"
    document = optimum_document(result, "")
    assert facts(document)["option that buys most"].endswith("as asked there is no solution")
    game = document.parts[-1]
    assert {fact.label for fact in game.facts} == {"as asked", "contact bronze (11 MPa)"}
    assert game.table.columns[0] == ["contact hard steel (600 MPa)", "contact steel (400 MPa)"]
    assert "gain[mm]" not in game.table.headers
    from drawing import draw_cam

    draw_cam("cam_optimum", task, result, tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_size > 1000


def test_another_law_keeps_the_follower_on_the_cam() -> None:
    task = roller_task(spring=Spring("given", stiffness=9500.0, preload=10.0), laws=("cosine",))
    weak = with_law(task, "const")
    weak = replace(weak, loads=replace(weak.loads, spring=Spring("given", stiffness=9500.0, preload=10.0)))
    with pytest.raises(NoSolutionError, match="leaves the cam"):
        solve_optimum(replace(weak, optimum=replace(task.optimum, laws=())), ROLLER)
    result = solve_optimum(weak, ROLLER)
    assert "leaves the cam" in result.refused
    assert result.shown == ("law cosine",)
    assert result.least == solve_optimum(roller_task(), ROLLER).least


def test_of_a_flat_face() -> None:
    task = flat_task(contacts=(("steel", 4e8),))
    result = solve_optimum(replace(task, requirements=replace(task.requirements, contact=1e6)), FLAT)
    assert result.refused
    assert result.least == solve_optimum(flat_task(), FLAT).least


def test_no_option_at_all_is_an_error() -> None:
    with pytest.raises(NoSolutionError, match=r"sigma_H = .*; no option has a solution either"):
        solve_optimum(soft(contacts=CONTACTS[:1]), ROLLER)
