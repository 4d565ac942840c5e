"""Permissible stresses: the worked example, every treatment against the tables, and what the tables do not have."""

from __future__ import annotations

from typing import Any

import pytest

from gears.strength.scenes import MPA, steel_40kh
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.endurance import Endurance, endurance
from tmmcalc.gears.strength.material import Material, parse_hardness


def of(symbol: str, found: Endurance) -> float:
    (value,) = [c.value for c in found.coefficients if c.symbol == symbol]
    return value


def material(treatment: str, hardness: str, steel: str = "", **others: Any) -> Material:
    return Material(treatment, parse_hardness(hardness), steel, **others)


# treatment, hardness, steel, others, load -> sigma_Hlim, S_H, sigma_Flim, S_F', K_FC, read off the printed tables
PRINTED = [
    (("improved", "300 HB", "40Kh", {}, "two-sided"), (670, 1.1, 540, 1.75, 0.65)),
    (("normalised", "200 HB", "45", {}, "one-sided"), (470, 1.1, 360, 1.75, 1.0)),
    (("carburised", "60 HRC", "20KhN", {}, "one-sided"), (1380, 1.2, 800, 1.75, 1.0)),
    (("carburised", "60 HRC", "20KhN", {"protected": True}, "one-sided"), (1380, 1.2, 950, 1.55, 1.0)),
    (("carburised", "57 HRC", "18KhGT", {"protected": True}, "two-sided"), (1311, 1.2, 810, 1.6, 0.75)),
    (("nitrocarburised", "58 HRC", "30KhGT", {}, "two-sided"), (1334, 1.2, 750, 1.55, 0.75)),
    (
        ("nitrided", "600 HV", "40KhFA", {"core": parse_hardness("30 HRC")}, "two-sided"),
        (1050, 1.2, 660, 1.75, 0.9),
    ),
    (("surface-hardened", "45 HRC", "", {}, "one-sided"), (965, 1.2, 400, 1.75, 1.0)),
    (("fillet-hardened", "50 HRC", "40KhN", {}, "two-sided"), (1050, 1.2, 700, 1.75, 0.75)),
    (("fillet-hardened", "50 HRC", "35KhM", {}, "one-sided"), (1050, 1.2, 600, 1.75, 1.0)),
    (
        ("through-hardened", "50 HRC", "40Kh", {"contact_limit": 900 * MPA}, "two-sided"),
        (900, 1.1, 500, 1.85, 0.75),
    ),
    (
        ("through-hardened", "50 HRC", "50KhN", {"contact_limit": 900 * MPA, "protected": True}, "one-sided"),
        (900, 1.1, 660, 1.75, 1.0),
    ),
    (("annealed", "180 HB", "", {"bending_limit": 300 * MPA}, "two-sided"), (430, 1.1, 300, 1.75, 0.65)),
]


@pytest.mark.parametrize(("given", "printed"), PRINTED)
def test_every_treatment(given: Any, printed: Any) -> None:
    treatment, hardness, steel, others, load = given
    found = endurance(material(treatment, hardness, steel, **others), load, "wheel 1")
    contact, safety, bending, first, sides = printed
    assert of("sigma_Hlim", found) == pytest.approx(contact * MPA, rel=1e-12)
    assert of("S_H", found) == safety
    assert of("sigma_Flim^0", found) == pytest.approx(bending * MPA, rel=1e-12)
    assert of("S_F'", found) == first
    assert of("K_FC", found) == sides
    assert found.permissible_contact == pytest.approx(contact * MPA / safety, rel=1e-12)
    assert found.permissible_bending == pytest.approx(bending * MPA * sides / first, rel=1e-12)
    assert all(c.source and c.of == "wheel 1" for c in found.coefficients)
    assert len(found.coefficients) == 8


def test_consequences_and_structure_and_blank() -> None:
    usual = endurance(steel_40kh(), "one-sided", "")
    assert endurance(steel_40kh(failure="severe"), "one-sided", "").permissible_contact == pytest.approx(
        usual.permissible_contact * 1.1 / 1.25, rel=1e-12
    )
    strengthened = endurance(steel_40kh(structure="surface-strengthened"), "one-sided", "")
    assert strengthened.permissible_contact == pytest.approx(usual.permissible_contact * 1.1 / 1.2, rel=1e-12)
    for blank, wear, second in (("rolled", "none", 1.15), ("casting", "none", 1.3), ("forging", "abrasive", 1.6)):
        found = endurance(steel_40kh(blank=blank, wear=wear), "one-sided", "")
        assert found.permissible_bending == pytest.approx(usual.permissible_bending / second, rel=1e-12)
    abrasive = endurance(steel_40kh(wear="abrasive"), "one-sided", "").coefficients
    assert any("the largest of 1.3 to 1.6" in c.source for c in abrasive)


def test_out_of_one_row_is_a_warning_out_of_all_an_error() -> None:
    assert endurance(steel_40kh("300 HB"), "one-sided", "wheel 1").warnings == ()
    (warning,) = endurance(steel_40kh("330 HB"), "one-sided", "wheel 1").warnings
    assert "330 HB is out of HB 180 to 300 (textbook, Table D.4.3" in warning
    (other,) = endurance(material("fillet-hardened", "45 HRC", "40Kh"), "one-sided", "").warnings
    assert "HRC 48 to 58" in other
    for given in (
        steel_40kh("400 HB"),
        material("carburised", "50 HRC", "20Kh"),
        material("fillet-hardened", "60 HRC", "40Kh"),
        material("surface-hardened", "60 HRC"),
        material("through-hardened", "40 HRC", "40Kh", contact_limit=9e8),
    ):
        with pytest.raises(UsageError, match="outside the tables") as error:
            endurance(given, "one-sided", "wheel 1")
        assert "contact_limit and bending_limit" in error.value.remedy
        assert error.value.where == "wheel 1"
    bare = material("improved", "400 HB", contact_limit=8e8, bending_limit=6e8)
    assert endurance(bare, "one-sided", "").warnings == ()


def test_a_doubtful_designation_is_told() -> None:
    (warning,) = endurance(material("carburised", "60 HRC", "20ХН2М"), "one-sided", "wheel 2").warnings
    assert "20KhN2M is doubtful" in warning


@pytest.mark.parametrize(
    ("given", "message", "remedy"),
    [
        (material("improved", "300 HB", "40KhM"), "no steel '40KhM'", "did you mean"),
        (material("improved", "300 HB"), "no steel ''", "bending_limit"),
        (
            material("carburised", "60 HRC", "45"),
            "no bending limit of 45 for carburised",
            "45 is normalised or improved",
        ),
        (material("through-hardened", "50 HRC", "40Kh"), "no contact limit for through-hardened", "contact_limit"),
        (material("annealed", "180 HB", "45"), "no bending limit of 45 for annealed", "bending_limit"),
        (material("improved", "30 HRC", "40Kh"), "is told in HB; 30 HRC is given", "give it in HB"),
        (material("nitrided", "50 HRC", "40KhFA"), "is told in HV", "give it in HV"),
        (material("nitrided", "600 HV", "40KhFA"), "hardness of its core", '"30 HRC"'),
        (material("nitrided", "600 HV", "40KhFA", core=parse_hardness("300 HB")), "the core of nitrided", "in HRC"),
        (material("fillet-hardened", "50 HRC", "", row="im"), "'im' is not a row", "rows: h1, h2"),
    ],
)
def test_what_the_tables_do_not_have(given: Material, message: str, remedy: str) -> None:
    with pytest.raises(UsageError, match=message) as error:
        endurance(given, "one-sided", "wheel 1")
    assert remedy in error.value.remedy


def test_a_similar_steel_takes_a_row() -> None:
    found = endurance(material("fillet-hardened", "50 HRC", "38KhGN", row="h1"), "one-sided", "")
    assert of("sigma_Flim^0", found) == 700 * MPA
    assert any("row h1" in c.source for c in found.coefficients)


def test_words_and_limits_of_a_material() -> None:
    for wrong in ({"treatment": "boiled"}, {"blank": "sintered"}, {"load": "three-sided"}, {"structure": "soft"}):
        with pytest.raises(UsageError, match="is not known") as error:
            Material(**{"treatment": "improved", "hardness": parse_hardness("300 HB"), **wrong})
        assert next(iter(wrong)) in error.value.remedy
    for value in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(UsageError, match="positive"):
            material("improved", "300 HB", contact_limit=value)
