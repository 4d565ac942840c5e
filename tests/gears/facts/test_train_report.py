"""The documents of the train stage: what is said of a task, and what each constraint removed."""

from __future__ import annotations

import pytest

import tmmcalc
from tmmcalc.gears.facts.train import document as train_document
from tmmcalc.gears.facts.train import summary as train_summary
from tmmcalc.pipeline.runner import run
from tmmcalc.report.document import Document

TWO = '[train]\nlayout = ["coaxial", "unfolded2"]\nratio = "8.15"\nmodule = "2 mm"\n'


def document(text: str, **flags: object) -> Document:
    result = run(tmmcalc.parse_spec(text), target="train").results["train"]
    return train_document(result, "title", **flags)


def facts(part: Document) -> dict[str, str]:
    return {fact.label: fact.text for fact in part.facts}


def test_several_variants_are_parts() -> None:
    coaxial, unfolded = document(TWO).parts
    assert (coaxial.title, unfolded.title) == ("coaxial with 1 layshaft", "unfolded2")
    assert facts(coaxial)["ratio"] == "u = 8.15, 8.0685 to 8.2315 admitted"
    assert "pinions to 25" in facts(unfolded)["numbers of teeth"]
    assert "proportions, 1:1 to 2:5" in facts(coaxial)["modules m_1:m_2"]
    assert coaxial.table is not None
    assert len(coaxial.table.columns[0]) == 20
    assert {"m_1:m_2", "e", "a_12[m]", "D[m]"} <= set(coaxial.table.headers)
    assert unfolded.table is not None
    assert not {"m_1:m_2", "e", "D[m]"} & set(unfolded.table.headers)


def test_removals_are_said_one_by_one() -> None:
    (unfolded,) = (part for part in document(TWO).parts if part.title == "unfolded2")
    said = facts(unfolded)
    left = int(said["candidates"].split()[0])
    for label in ("- ratio", "- ratio of one stage", "- diameters alike"):
        _, removed, _, of = said[label].split()
        assert int(of) == left
        left -= int(removed)
    assert said["tooth sets"].splitlines()[0] == str(left)


def test_everything_is_one_table() -> None:
    whole = document(TWO, everything=True)
    assert whole.table is not None
    assert whole.table.headers[:2] == ["layout", "planets"]
    assert set(whole.table.columns[0]) == {"coaxial", "unfolded2"}
    assert all(part.table is None for part in whole.parts)


def test_the_summary_is_short() -> None:
    result = run(tmmcalc.parse_spec(TWO), target="train").results["train"]
    for part in train_summary(result, "train").parts:
        assert part.table is not None
        assert len(part.table.columns[0]) == 5


def test_bounds_of_the_step_are_told_for_one_proportion() -> None:
    """The textbook's worked example, GT-S07."""
    text = '[train]\nlayout = "AI"\nratio = 22\nratio_kind = "u"\ntolerance = 0.02\nmodule_ratios = [[2, 3]]\n'
    ((values, said),) = [(fact.values, fact.text) for fact in document(text).facts if fact.label == "step e"]
    assert values == pytest.approx(
        {
            "e_min_teeth": 31.897599,
            "e_first": 32,
            "e_max": 166.5,
            "e_min_neighbours": 29.290715,
            "e_min_neighbours_textbook": 31.638835,
        },
        abs=1e-5,
    )
    assert said.startswith("from 32 to 166.5: by teeth 31.8976, by neighbours")
