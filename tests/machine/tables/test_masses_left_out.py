"""Masses of an elastic drive move by themselves in motions in time alone: without [[transients]] none is asked for."""

from __future__ import annotations

import pytest

import tmmcalc
from tmmcalc.project import templates

FULL = (templates.folder() / "elastic-drive.toml").read_text(encoding="utf-8")


def without(text: str, table: str, key: str) -> str:
    """The text without a key of the first table of this name."""
    head, _, rest = text.partition(f"\n{table}")
    lines = rest.splitlines(keepends=True)
    at = next(k for k, line in enumerate(lines) if line.startswith(f"{key} ="))
    return f"{head}\n{table}{''.join(lines[:at] + lines[at + 1 :])}"


def rigid(text: str) -> str:
    return text[: text.index("\n[[transients]]")]


@pytest.mark.parametrize(("table", "words"), [("[[shafts]]", "between this shaft and the next"), ("[motor]", "rotor")])
def test_an_inertia_is_asked_for_with_motions_in_time(table: str, words: str) -> None:
    bare = without(FULL, table, "inertia")
    assert "[[transients]]" not in rigid(bare)
    with pytest.raises(tmmcalc.SpecError, match=rf"missing key: .*{words}"):
        tmmcalc.parse_spec(bare)
    assert tmmcalc.parse_spec(rigid(bare)).transients == tmmcalc.parse_spec(rigid(FULL)).transients


def test_masses_between_the_shafts_change_nothing_without_motions_in_time() -> None:
    one, other = (
        tmmcalc.run(tmmcalc.parse_spec(rigid(text))) for text in (FULL, without(FULL, "[[shafts]]", "inertia"))
    )
    assert [*one.results] == [*other.results]
    assert "motion" in one.results
    assert "transient" not in one.results
    for result in (run.results for run in (one, other)):
        assert result["motion"].omega.tolist() == one.results["motion"].omega.tolist()
        assert result["flywheel"].inertia == one.results["flywheel"].inertia
        assert result["power"].mean_moment == one.results["power"].mean_moment
