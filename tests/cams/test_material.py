"""The allowed contact stress of a cam by its steel: rows of D.4.4 and D.4.5 by hand, and the margin that it gives."""

from __future__ import annotations

import pytest

import tmmcalc
from tmmcalc.cams.strength.material import TREATMENTS, allowed_contact
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.tables import ContactRow, table
from tmmcalc.project import templates


@pytest.mark.parametrize(
    ("treatment", "hardness", "failure", "expected"),
    [
        ("normalised", "200 HB", "ordinary", (2 * 200 + 70) / 1.1),
        ("improved", "300 HB", "severe", (2 * 300 + 70) / 1.25),
        ("surface-hardened", "45 HRC", "ordinary", (17 * 45 + 200) / 1.2),
        ("carburised", "60 HRC", "severe", 23 * 60 / 1.35),
        ("nitrided", "700 HV", "ordinary", 1050 / 1.2),
    ],
)
def test_rows_of_the_textbook(treatment: str, hardness: str, failure: str, expected: float) -> None:
    allowed, source = allowed_contact(treatment, hardness, failure)
    assert allowed / 1e6 == pytest.approx(expected)
    assert "D.4.4" in source
    assert f"{failure} consequences" in source


def test_all_treatments_have_a_row() -> None:
    rows = {treatment for row in table(ContactRow) for treatment in row.treatments}
    assert {*TREATMENTS} <= rows


def test_a_hardness_that_the_treatment_does_not_give() -> None:
    with pytest.raises(UsageError, match="outside the tables"):
        allowed_contact("carburised", "40 HRC", "ordinary")


def test_the_margin_is_that_of_the_stress_itself() -> None:
    text = templates.path("cam-translating").read_text()
    steel = text.replace('contact = "400 MPa"', 'material = { treatment = "improved", hardness = "300 HB" }')
    same = text.replace('contact = "400 MPa"', f"contact = {670e6 / 1.1!r}")
    one, other = (tmmcalc.solve_cam_strength(tmmcalc.parse_spec(each)) for each in (steel, same))
    (found,), (told,) = ([m for m in each.margins if m.name == "contact stress"] for each in (one, other))
    assert found.margin == pytest.approx(told.margin)
    assert "sigma_Hlim/S_H = 670 MPa/1.1" in found.formula
    assert "sigma_Hlim" not in told.formula
