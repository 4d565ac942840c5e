"""The language of names: what is a name, what it names, and what is told of one that is none."""

from __future__ import annotations

import pytest

from tmmcalc import rooms
from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import OF, Name, Place, is_name, near, parse, rank, stages_of

FORMS = {
    "motion.delta": Name("motion", "", "delta"),
    "delta": Name("", "", "delta"),
    "kinematics.stroke_D[m]": Name("kinematics", "", "stroke_D", None, "m"),
    "kinematics.S_D@12": Name("kinematics", "", "S_D", Place("", "12")),
    "kinematics.S_D@6'[m]": Name("kinematics", "", "S_D", Place("", "6'"), "m"),
    "v_D[phi=45 deg]": Name("", "", "v_D", Place("phi", "45 deg")),
    " vS_D[ t = 0.2 s ][m/s] ": Name("", "", "vS_D", Place("t", "0.2 s"), "m/s"),
    "forces.max(R_A)": Name("forces", "max", "R_A"),
    "max(R_A)[N]": Name("", "max", "R_A", None, "N"),
    "forces.max(R_A)@2..12": Name("forces", "max", "R_A", Place("", "2", "12")),
    "*.max(R_*)[phi=10..50][N]": Name("*", "max", "R_*", Place("phi", "10", "50"), "N"),
    "check_h.achieved": Name("", "", "check_h.achieved"),
    "transmission_min_RRR(2,3)[deg]": Name("", "", "transmission_min_RRR(2,3)", None, "deg"),
    "kinematics.variants.RPR(2,3)": Name("kinematics", "", "variants.RPR(2,3)"),
}
WRONG = {
    "": "a quantity is missing",
    "kinematics.": "a quantity is missing",
    "forces.max(R_A": "what is asked of a column is",
    "forces.max()": "what is asked of a column is",
    "forces.max(R_A)x": "what is asked of a column is",
    "forces.mx(R_A)": "did you mean max?",
    "S_D@": "a place is one value, or two",
    "max(S_D)@1..2..3": "a place is one value, or two",
    "S_D@1..2": "it has to say what is asked, such as max(S_D)@1..2",
    "S_D[=45 deg]": "a place is a column and its value",
    "S_D@2[phi=45 deg]": "it has two places",
    "S_D[m][mm]": "it has two units",
    "a" * 300: "longer than 200 characters",
}


@pytest.mark.parametrize("text", FORMS)
def test_every_form(text: str) -> None:
    name = parse(text)
    assert name == FORMS[text]
    assert parse(name.text) == name._replace(unit=None)


@pytest.mark.parametrize("text", WRONG)
def test_what_is_no_name_is_told(text: str) -> None:
    with pytest.raises(UsageError) as refused:
        parse(text)
    assert WRONG[text] in refused.value.message
    assert refused.value.remedy or "longer" in refused.value.message


@pytest.mark.parametrize("of", OF)
def test_every_function(of: str) -> None:
    assert parse(f"forces.{of}(R_A)") == Name("forces", of, "R_A")


def test_a_name_of_many_brackets_is_read_at_once() -> None:
    for text in ("(" * 199, "[=" * 99 + "]", "*" * 199, "max(" * 49, "[" * 100 + "]" * 99):
        try:
            parse(text)
        except UsageError:
            continue


@pytest.mark.parametrize(
    ("told", "pattern"),
    [
        ("kinematics.stroke_D[m]", "stroke_?"),
        ("kinematics.stroke_D[m]", "kin*"),
        ("kinematics.stroke_D[m]", "*_D[m]"),
        ("forces.max(R_A)[N]", "max(R_*)"),
        ("forces.max(R_A)@2..12[N]", "f*.max(R_A)@2..12"),
        ("kinematics.vS_D[phi=45 deg][m/s]", "vS_*[phi=45 deg]"),
    ],
)
def test_a_pattern_names(told: str, pattern: str) -> None:
    assert rank(told, ["motion.*", pattern]) == 1


@pytest.mark.parametrize("pattern", ["max(R_A)", "max(R_A)@2..11", "min(R_A)@2..12", "max(R_A)@2..12[kN]", "R_A@2"])
def test_a_pattern_of_another_place_function_or_unit_does_not(pattern: str) -> None:
    assert rank("forces.max(R_A)@2..12[N]", [pattern]) is None


def test_stages_of_patterns() -> None:
    assert stages_of(["forces.max(R_A)@2", "kinematics.S_D@3"], rooms.STAGES) == ("kinematics", "forces")
    assert stages_of(["forces.max(R_A)", "delta"], rooms.STAGES) == ()


@pytest.mark.parametrize(
    ("value", "named"), [("motion.delta", True), ("max(R_A)", True), ("-3", False), (3, False), ("", False)]
)
def test_a_quantity_is_no_name(value: object, named: bool) -> None:
    assert is_name(value) is named


def test_the_nearest_names_are_told_with_and_without_their_stage() -> None:
    known = ["kinematics.stroke_D", "motion.delta"]
    assert near("strok_D", known, "facts") == "did you mean kinematics.stroke_D?"
    assert near("qqq", known, "facts") == "facts: kinematics.stroke_D, motion.delta"
