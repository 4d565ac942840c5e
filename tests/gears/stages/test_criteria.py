"""The criteria stage: worked cases, front, ranking and comparisons against plain loops, trains in series."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from gears.stages.trains import ABSOLUTE, AI, AIBAR, CASES, COAXIAL, LOADED, UNFOLDED, at, chosen
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Note
from tmmcalc.gears.facts.criteria import summary
from tmmcalc.gears.selection.columns import chosen_columns
from tmmcalc.gears.selection.results import MEASURES, Selection
from tmmcalc.gears.split import best_split
from tmmcalc.pipeline.runner import run

STRONG = 'permissible_contact = "5000 MPa"\npermissible_bending = "5000 MPa"\n'  # given modules are enough
GIVEN = [  # case, train, modules and widths of its rows [mm]
    ("GT-S14", UNFOLDED, lambda row: ((row["m1_std"], row["m2_std"]), (row["b1"], row["b2"]))),
    ("GT-S15", AIBAR, lambda row: ((row["m_std"],), (row["b_book"],))),
    (
        "GT-S17",
        f'layout = "AIbar"\nratio = "5.594"\ntolerance = "0.1"\n{ABSOLUTE}',
        lambda row: ((row["m_std"],), (row["b_book"],)),
    ),
]


def weighed(train: str, row: dict[str, Any], modules: tuple[float, ...], widths: tuple[float, ...]) -> dict[str, float]:
    """The criteria of the train of a case, its modules and widths given."""
    sizes = f"module = {[m / 1000 for m in modules]}\nwidth = {[b / 1000 for b in widths]}\n"
    found = chosen(train, f"torque = 22\n{sizes}{STRONG}")
    place = at(found.variants[0].sets.teeth, row["z"])
    return {name: float(getattr(found.pool, name)[place]) for name in MEASURES}


@pytest.mark.parametrize(("case", "train", "sizes"), GIVEN, ids=[case for case, _, _ in GIVEN])
def test_mass_inertia_size_of_the_tables(case: str, train: str, sizes: Any) -> None:
    for row in CASES[case]["expected"]["rows"][::2]:
        found = weighed(train, row, *sizes(row))
        assert found["mass"] == pytest.approx(row["M_sum_kg"], abs=6e-5)
        assert found["inertia"] == pytest.approx(row["J_kgm2"], abs=6e-7)
        assert 1000 * found["size"] == pytest.approx(row["D_mm"], abs=1e-9)


@pytest.mark.parametrize(("widths", "told"), [((8.0, 120.0), [(1, 4.0, 6.0), (2, 60.0, 40.0)]), ((12.0, 80.0), [])])
def test_unusual_widths_are_told_by_stage(widths: tuple[float, float], told: list[tuple[int, float, float]]) -> None:
    """b/m of both stages, of modules of 2 mm; the ends 6 and 40 themselves are usual."""
    sizes = f"module = [0.002, 0.002]\nwidth = {[b / 1000 for b in widths]}\n"
    found = chosen(UNFOLDED, f"torque = 22\n{sizes}{STRONG}")
    notes = [each for each in summary(found, "criteria").notes if isinstance(each, Note) and "face width" in each]
    assert [(each.name, each.level) for each in notes] == [(f"b_{k}/m_{k}", "warning") for k, _, _ in told]
    assert [(each.value, each.limit) for each in notes] == [pytest.approx(numbers) for _, *numbers in told]
    worst = max((max(limit / value, value / limit) - 1 for _, value, limit in told), default=0.0)
    assert found.winner.values["width_deviation"] == pytest.approx(worst)


@pytest.mark.parametrize("planets", [1, 3])
def test_coaxial_reducer(planets: int) -> None:
    """GT-S19; with three layshafts the set does not go in: the assembly is not asked for."""
    case = CASES["GT-S19"]
    given, expected = case["inputs"], case["expected"][f"K{planets}"]
    train = f"{COAXIAL}planets = {planets}\nconstraints = {{ assembly = false, adjacency_gap = false }}\n"
    found = weighed(train, given, (given["m1"], given["m2"]), (given["b1"], given["b2"]))
    assert found["mass"] == pytest.approx(expected["M_sum_kg"], abs=6e-7)
    assert found["inertia"] == pytest.approx(expected["J_kgm2"], abs=6e-9)
    assert 1000 * found["size"] == pytest.approx(expected["D_mm"], abs=1e-9)


def test_the_whole_chain() -> None:
    """GT-S18: search, strength, standard modules, criteria, front, winner."""
    found, expected = chosen(AI), CASES["GT-S18"]["expected"]
    columns = chosen_columns(found)
    teeth = found.variants[0].sets.teeth
    assert len(teeth) == expected["n_candidates"]
    for row in expected["candidates"]:
        place = at(teeth, row["z"])
        for name, factor in (("m1", 1000), ("m2", 1000), ("b1", 1000), ("b2", 1000)):
            assert factor * columns[f"{name[0]}_{name[1]}[m]"][place] == pytest.approx(row[name], abs=1e-9)
        assert columns["mass[kg]"][place] == pytest.approx(row["M_sum_kg"], abs=6e-5)
        assert columns["inertia[kg*m^2]"][place] == pytest.approx(row["J_kgm2"], abs=6e-6)
        assert 1000 * columns["size[m]"][place] == pytest.approx(row["D_mm"], abs=1e-9)
    front = sorted(teeth[columns["front"] == "yes"].tolist())
    assert front == sorted(row["z"] for row in expected["pareto_front"])
    best = min(expected["candidates"], key=lambda row: row["J_kgm2"])
    assert list(found.winner.teeth) == best["z"]
    assert found.reason.runner_up_value == pytest.approx(
        sorted(r["J_kgm2"] for r in expected["candidates"])[1], abs=1e-5
    )
    z1, z2, z2b, z3 = best["z"]
    assert found.winner.ratio == 1 + Fraction(z2 * z3, z1 * z2b)


SEVERAL = (
    'layout = ["AIbar", "AI"]\nratio = "6.5"\nplanets = [2, 3, 4]\nmodule_ratios = [[1, 1], [2, 3]]\nsum_max = 110\n'
)


@pytest.fixture(scope="module")
def several() -> Selection:
    criteria = 'objectives = ["mass", "size", "efficiency", "error"]\nweights = { mass = 1, inertia = 3 }\n'
    return chosen(SEVERAL, LOADED, criteria + 'choose = "weighted"\n')


@pytest.mark.slow
def test_front_of_several_layouts(several: Selection) -> None:
    """All variants together; every pair is compared."""
    pool = several.pool
    costs = np.stack([pool.mass, pool.size, -pool.efficiency, pool.error], axis=1)
    dominated = [bool(np.any((costs <= row).all(axis=1) & (costs < row).any(axis=1))) for row in costs]
    assert several.front.tolist() == np.flatnonzero(~np.array(dominated)).tolist()
    assert 0 < len(several.front) < len(pool)
    assert {each.sets.layout for each in several.variants if len(each.sets)} == {"AIbar", "AI"}


def test_ranking(several: Selection) -> None:
    def scaled(values: np.ndarray) -> np.ndarray:
        return (values - values.min()) / (values.max() - values.min())

    pool = several.pool
    scores = 0.25 * scaled(pool.mass) + 0.75 * scaled(pool.inertia)
    assert several.ranking.scores == pytest.approx(scores, abs=1e-14)
    assert several.winner.place == int(np.argmin(scores)) == several.reason.winner
    assert chosen_columns(several)["rank"][several.winner.place] == 1


def test_more_planets_are_better(several: Selection) -> None:
    """Textbook 4.6: of the numbers of planets that go in the largest improves mass and size."""
    compared = {each.criterion: each for each in several.by_planets}
    assert compared["mass"].winner == compared["size"].winner == 4
    for key, each in compared.items():
        for option in each.options:
            rows = [
                v for v in several.variants if (v.sets.layout, v.sets.planets) == (several.winner.layout, option.option)
            ]
            values = getattr(rows[0].criteria, key)
            best = values.max() if key == "efficiency" else values.min()
            assert option.values[key] == best


def test_layouts(several: Selection) -> None:
    for each in several.by_layouts:
        values: dict[str, float] = {}
        for variant in several.variants:
            own = getattr(variant.criteria, each.criterion)
            best = max if each.criterion == "efficiency" else min
            layout = variant.sets.layout
            values[layout] = best([*own.tolist(), *([values[layout]] if layout in values else [])])
        assert {option.option: option.values[each.criterion] for option in each.options} == values
        assert each.value == (max if each.criterion == "efficiency" else min)(values.values())


def test_a_row_that_is_asked_for() -> None:
    best = chosen(AI, LOADED, "choose = 7")
    assert (best.winner.place, best.choose) == (6, "row")
    assert chosen_columns(best)["i"][6] == 7
    assert chosen(AI, LOADED, "choose = 11").winner.place == 10
    with pytest.raises(UsageError, match="there is no row 12: 11 trains"):
        chosen(AI, LOADED, "choose = 12")


def test_the_most_efficient() -> None:
    found = chosen(AI, LOADED, 'choose = "efficiency"\nexternal_efficiency = 0.98\ninternal_efficiency = 0.99')
    i = 1 + np.prod(found.variants[0].sets.teeth[:, [1, 3]], axis=1) / np.prod(
        found.variants[0].sets.teeth[:, [0, 2]], axis=1
    )
    eta = 0.98 * 0.99
    assert found.pool.efficiency == pytest.approx(eta + (1 - eta) / i, rel=1e-14)
    assert found.winner.place == int(np.argmin(i))


def test_error_is_that_of_the_ratio_as_it_was_asked_for() -> None:
    found = chosen(AI)
    for teeth, error in zip(found.variants[0].sets.teeth.tolist(), found.pool.error, strict=True):
        z1, z2, z2b, z3 = teeth
        assert error == pytest.approx(abs(float((1 + Fraction(z2 * z3, z1 * z2b)) / Fraction("31.29") - 1)), rel=1e-12)


def test_a_carrier_that_drives() -> None:
    """The output is wheel 1: the ratio is i_H1, the efficiency that of table 4.6, the inertia reduced to wheel 1."""
    train = 'layout = "AA"\nratio_kind = "i_H1"\nratio = 10000\ntolerance = "0.1 %"\nplanets = 1\nz_max = 110\n'
    train += 'module_ratios = [[1, 1]]\nconstraints = { mesh_angle_max = "22 deg" }\n'
    found = chosen(train)
    best, (variant,) = found.winner, found.variants
    z1, z2, z2b, z3 = best.teeth
    i_1 = 1 - Fraction(z2 * z3, z1 * z2b)
    assert best.ratio == 1 / i_1
    eta, i = 0.975**2, float(i_1)
    direct = 1 / (eta + (1 - eta) / i) if i > 0 else eta / (1 + (1 - eta) / -i)
    assert best.values["efficiency"] == pytest.approx(direct, rel=1e-9)
    (m_1, m_2), (b_1, b_2) = best.modules, best.widths
    pinions = [(math.pi * (m * z / 2) ** 2 * b * 7820, m * z / 2) for z, m, b in ((z1, m_1, b_1), (z2b, m_2, b_2))]
    wheel = 0.434 * math.pi * (m_1 * z2 / 2) ** 2 * b_1 * 7820
    own = 1.21 * wheel * (m_1 * z2 / 2) ** 2 / 2 + pinions[1][0] * pinions[1][1] ** 2 / 2
    a = float(np.cos(math.radians(20)) / np.cos(variant.sets.angles[best.place, 0])) * m_1 * (z1 + z2) / 2
    on_carrier = pinions[0][0] * pinions[0][1] ** 2 / 2 * i**2
    on_carrier += own * (1 + z3 / z2b) ** 2 + (wheel + pinions[1][0]) * a**2
    assert best.inertia == pytest.approx(on_carrier / i**2, rel=1e-9)


def test_trains_that_lock_themselves_are_left_out() -> None:
    """Wheel 1 drives and i_1H is below the losses of a mesh: table 4.6 gives an efficiency below zero."""
    train = 'layout = "AA"\nratio = "0.02"\nplanets = 1\nmodule_ratios = [[1, 1]]\ntolerance = "5 %"\n'
    with pytest.raises(NoSolutionError, match="self-locking") as caught:
        chosen(train)
    assert caught.value.exit_code == 3


def test_nothing_is_strong_enough() -> None:
    with pytest.raises(NoSolutionError, match="11 of 11 sets are not strong enough, such as 22/118/17/97") as caught:
        chosen(AI, LOADED.replace("75", "7500000"))
    assert caught.value.exit_code == 3


def test_trains_in_series() -> None:
    """Every pair of the front by (4.45) and the sums of 4.6.3, from its teeth, modules and widths."""
    found = chosen(AI, LOADED, "series = true").pairs
    assert found is not None
    assert found.front is not None
    assert found.first is not None
    assert found.second is not None
    assert found.modules is not None
    assert found.widths is not None
    assert float(found.single) == pytest.approx(math.sqrt(31.29), abs=1e-6)
    for k in range(len(found.front)):
        parts = []
        for sets, place in ((found.first, 0), (found.second, 1)):
            z1, z2, z3 = sets.teeth[k].tolist()
            m, b = found.modules[k, place], found.widths[k, place]
            parts.append((1 + Fraction(z3, z1), *by_hand(z1, z2, z3, m, b, 3)))
        (i_1, m_1, j_1), (i_2, m_2, j_2) = parts
        assert abs(i_1 * i_2 - Fraction("31.29")) <= Fraction("0.5")
        assert found.front.mass[k] == pytest.approx(m_1 + m_2, rel=1e-12)
        assert found.front.inertia[k] == pytest.approx(j_1 * float(i_2) ** 2 + j_2, rel=1e-12)
    assert found.best is not None
    assert found.best["mass"] == found.front.mass.min()


def by_hand(z1: int, z2: int, z3: int, m: float, b: float, planets: int) -> tuple[float, float]:
    """Mass and reduced inertia of a train AIbar (4.43 to 4.47)."""
    sun = math.pi * (m * z1 / 2) ** 2 * b * 7820
    planet = 0.434 * math.pi * (m * z2 / 2) ** 2 * b * 7820
    i_1, i_2, a = 1 + z3 / z1, 1 - z3 / z2, m * (z1 + z2) / 2
    own = sun * (m * z1 / 2) ** 2 / 2 * i_1**2
    carried = planets * (1.21 * planet * (m * z2 / 2) ** 2 / 2 * i_2**2 + planet * a**2)
    return sun + planets * planet, own + carried


def test_a_ratio_that_two_trains_cannot_share() -> None:
    found = chosen(COAXIAL.replace("8.15", "3.2"), LOADED, "series = true")
    assert found.pairs is not None
    assert found.pairs.best is None
    assert "each has i_1H above 2" in found.pairs.failure


def test_what_theory_proposes() -> None:
    (guide,) = chosen(UNFOLDED).guides
    assert [split.criterion for split in guide.splits] == ["equal diameters", "mass", "inertia", "size"]
    assert guide.splits[0].ratios == pytest.approx([8.15**0.6, 8.15**0.4], rel=1e-14)
    assert guide.splits[2].ratios == pytest.approx(best_split(8.15, "inertia").ratios, rel=1e-14)
    (tied,) = chosen(COAXIAL).guides
    assert tied.proportion == pytest.approx(1.70357, abs=1e-5)  # GT-S03


def test_files_give_back_what_was_computed(tmp_path: Path) -> None:
    spec = tmmcalc.parse_spec(f"[train]\n{AI}\n[strength]\n{LOADED}\n[criteria]\nseries = true\n")
    first, again = (run(spec, out=tmp_path) for _ in range(2))
    assert {event.kind for event in again.events if event.stage in ("train", "strength", "criteria")} == {"loaded"}
    one, other = (found.results["criteria"] for found in (first, again))
    assert (one.winner, one.minima, one.by_layouts, one.reason) == (
        other.winner,
        other.minima,
        other.by_layouts,
        other.reason,
    )
    assert np.array_equal(one.pairs.front.inertia, other.pairs.front.inertia)
    header, *rows = (tmp_path / "criteria.csv").read_text().splitlines()
    assert header == (
        "i,layout,K,z_1,z_2,z_2',z_3,m_1[m],m_2[m],b_1[m],b_2[m],mass[kg],inertia[kg*m^2],size[m],envelope[m],"
        "efficiency,error,front,rank"
    )
    assert len(rows) == 11
    assert float(rows[3].split(",")[12]) == one.pool.inertia[3]
