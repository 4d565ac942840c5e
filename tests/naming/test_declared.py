"""Names of columns that are told to be none before anything is computed; and that none of a result ever is."""

from __future__ import annotations

from pathlib import Path

import pytest
from sparing import sparing

import tmmcalc
from naming.solved import solved
from tmmcalc.naming.declared import Form, check_columns, forms_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.rooms import STAGES

CONFIGS = Path(__file__).parents[2] / "configs"
LINKAGES = ["shaper", "press", "class-three", "hydraulic-lift", "scotch-yoke", "course-project", "four-stroke-engine"]
EVERY = sorted({path.stem for path in CONFIGS.glob("*.toml")} - set(LINKAGES))


def check_all(name: str) -> None:
    found = solved(CONFIGS / f"{name}.toml")
    for stage, outcome in found.outcomes.items():
        forms, table = forms_of(STAGES[stage], found.spec), outcome.table
        if table is None or forms is None:
            continue
        headers = [*table.header, *(column.header for column in STAGES[stage].further(found.spec, found.results))]
        for header in headers:
            word = header.partition("[")[0]
            for asked in (header, word, f"{word[:2]}*"):
                assert word == "i" or any(form.may_be(asked) for form in forms), (stage, asked)


@sparing("name", LINKAGES, every=4)
def test_no_column_of_a_linkage_is_refused(name: str) -> None:
    """Of tables and by choice, by name, header and wildcard."""
    check_all(name)


@sparing("name", EVERY, every=10)
def test_no_column_is_refused(name: str) -> None:
    check_all(name)


def test_what_a_linkage_has_not_is_refused() -> None:
    spec = load_spec(CONFIGS / "shaper.toml")
    refused = {
        "kinematics": ("x_Q", "vx_D0", "omega_9", "s_A", "q_D", "an_Q_B", "X_D", "x_Q[m]", "x_[QR]", "qq*"),
        "forces": ("R_Q", "N_A", "M_fr_D0", "Pi_9_x", "eq_9_M_G9", "lever", "x_*_y"),
        "reduction": ("M_redd", "load_Q7"),
        "motion": ("omegaa", "phi2"),
    }
    for stage, names in refused.items():
        for name in names:
            with pytest.raises(tmmcalc.UsageError, match="called"):
                check_columns([name], [STAGES[stage]], spec)


def test_every_slip_is_told_with_the_nearest_names() -> None:
    spec = load_spec(CONFIGS / "shaper.toml")
    with pytest.raises(tmmcalc.UsageError) as told:
        check_columns(["vx_D", "R_Q", "x_D1"], [STAGES["kinematics"], STAGES["forces"]], spec)
    assert told.value.message == "no stage has a column called 'R_Q' or 'x_D1'"
    assert [line.split(":")[0].strip() for line in (told.value.remedy or "").splitlines()] == ["R_Q", "x_D1"]
    for line in (told.value.remedy or "").splitlines():
        near = line.partition("did you mean ")[2].rstrip("?").split(", ")
        check_columns(near, [STAGES["kinematics"], STAGES["forces"]], spec)


def test_what_stands_nearest_is_a_column() -> None:
    """No fact: omega_max is one of the motion."""
    spec = load_spec(CONFIGS / "shaper.toml")
    with pytest.raises(tmmcalc.UsageError) as told:
        check_columns(["omegaa"], [STAGES["motion"]], spec)
    near = (told.value.remedy or "").partition("did you mean ")[2].rstrip("?").split(", ")
    found = run(spec, target="motion")
    table = found.outcomes["motion"].table
    assert table is not None
    further = {column.name for column in STAGES["motion"].further(spec, found.results)}
    assert {*near} <= {*further, *(header.partition("[")[0] for header in table.header)}


def test_a_stage_that_does_not_say_may_have_any() -> None:
    assert STAGES["synthesis"].part("declares") is None
    check_columns(["nothing like it"], [STAGES["forces"], STAGES["synthesis"]], load_spec(CONFIGS / "shaper.toml"))
    assert forms_of(STAGES["structure"], None) == []  # it has no table


@pytest.mark.parametrize(
    ("pattern", "may"),
    [
        ("R_A", True),
        ("R_A[N]", True),
        ("R_?", True),
        ("*A*", True),
        ("R_[AB]", True),
        ("R_", False),
        ("R_AB", False),
        ("R_A_x", False),
        ("?", False),
        ("*_B", True),
        ("*_x", False),
    ],
)
def test_a_form(pattern: str, may: bool) -> None:
    assert Form("R_{joint}", {"joint": ("A", "B")}).may_be(pattern) is may
    assert not Form("N_{slide}", {"slide": ()}).may_be("N_")
