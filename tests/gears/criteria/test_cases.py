"""Worked cases GT-S14 to GT-S19: mass, reduced inertia and size of the textbook's tables, and a Pareto front."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from gears.criteria.worked import CASES, sets
from tmmcalc.gears.criteria.choice import front, least
from tmmcalc.gears.criteria.evaluate import Criteria, evaluate
from tmmcalc.gears.model import ToothSets

LAYOUTS = {"GT-S14": "unfolded2", "GT-S15": "AIbar", "GT-S16": "AI", "GT-S17": "AIbar", "GT-S18": "AI"}
MODULES, WIDTHS = ("m1_std", "m2_std", "m1", "m2", "m_std"), ("b1", "b2", "b1_book", "b2_book", "b_book")


def rows_of(name: str) -> list[dict[str, Any]]:
    expected = CASES[name]["expected"]
    rows: list[dict[str, Any]] = expected.get("rows") or expected["candidates"]
    return rows


def evaluated(name: str) -> tuple[ToothSets, Criteria]:
    rows = rows_of(name)
    train = sets(LAYOUTS[name], [row["z"] for row in rows], CASES[name]["inputs"].get("K", 1))
    module, width = (
        np.array([[row[key] for key in keys if key in row] for row in rows]) / 1000 for keys in (MODULES, WIDTHS)
    )
    return train, evaluate(train, module, width, Fraction("30.29"))


@pytest.mark.parametrize("name", LAYOUTS)
def test_mass_inertia_size(name: str) -> None:
    rows, tolerance = rows_of(name), CASES[name]["tolerance"]
    found = evaluated(name)[1]
    # the cases are rounded to the last digit given
    assert found.mass == pytest.approx([row["M_sum_kg"] for row in rows], abs=6e-5)
    assert found.inertia == pytest.approx([row["J_kgm2"] for row in rows], abs=min(tolerance["J_kgm2"], 6e-6))
    assert found.size * 1000 == pytest.approx([row["D_mm"] for row in rows], abs=1e-9)


def test_speeds_and_centre_distances_of_the_double_planet_train() -> None:
    rows = rows_of("GT-S16")
    found = evaluated("GT-S16")[1]
    assert found.ratio == pytest.approx([row["i_1H"] for row in rows], abs=1e-6)
    assert found.planet_ratio == pytest.approx([row["i_2H"] for row in rows], abs=1e-6)
    assert found.centre_distances[:, 0] * 1000 == pytest.approx([row["a_w_mm"] for row in rows], abs=1e-9)


def test_best_of_the_admitted_variants() -> None:
    """The textbook chooses among the variants whose second stage is strong enough."""
    expected = CASES["GT-S16"]["expected"]
    found = evaluated("GT-S16")[1]
    kept = [k for k, row in enumerate(rows_of("GT-S16")) if row["variant"] in expected["best_among"]]
    for key in ("mass", "inertia"):
        values = getattr(found, key)[kept]
        letter = {"mass": "M", "inertia": "J"}[key]
        assert expected["best_among"][int(np.argmin(values))] == expected[f"best_{letter}_variant"]
    everything = least(found, "mass")
    assert rows_of("GT-S16")[everything.winner]["variant"] == 6  # which the textbook rejects as overloaded


def test_pareto_front_of_the_whole_chain() -> None:
    train, found = evaluated("GT-S18")
    chosen = train.teeth[front(found, ["mass", "inertia", "size"])].tolist()
    assert sorted(chosen) == sorted(row["z"] for row in CASES["GT-S18"]["expected"]["pareto_front"])


@pytest.mark.parametrize("planets", [1, 3])
def test_coaxial_reducer(planets: int) -> None:
    given, expected = CASES["GT-S19"]["inputs"], CASES["GT-S19"]["expected"][f"K{planets}"]
    train = sets("coaxial", [given["z"]], planets)
    module, width = (np.array([[given[f"{key}1"], given[f"{key}2"]]]) / 1000 for key in "mb")
    found = evaluate(train, module, width)
    assert found.mass[0] == pytest.approx(expected["M_sum_kg"], abs=6e-7)
    assert found.inertia[0] == pytest.approx(expected["J_kgm2"], abs=6e-9)
    assert found.size[0] * 1000 == pytest.approx(expected["D_mm"], abs=1e-9)
