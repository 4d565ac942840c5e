"""Specs that no class can be made of: each fault with one message that says where, what, and what to write."""

from __future__ import annotations

import pytest

from tmmcalc.core.errors import SpecError
from tmmcalc.project.loader import parse_spec

from .test_draws import MECHANISM

CRANK = "mechanism.links[id=1].points.A[0]"
ROD = "mechanism.links[id=2].points.B[0]"
RANGE = 'at_least = "80 mm"\nat_most = "120 mm"\nstep = "5 mm"'
FACTORS = 'at_least = 3\nat_most = 4\nstep = "1 cm"'
MORE = f'[[class.drawn]]\nof = "{CRANK}"\n{RANGE}\n'


def one(rest: str, of: str = f'"{CRANK}"') -> str:
    return f"[[class.drawn]]\nof = {of}\n{rest}\n"


def asked(*rest: str) -> str:
    return MORE + "".join(f'[[class.asked]]\nresult = "kinematics.{each}\n' for each in rest)


FAULTS = {
    "no key": (one(RANGE, '"mechanism.links[id=7].mass"'), "has no element with id = 7", "there are: 1, 2, 3"),
    "no number": (one(RANGE, '"mechanism.input.joint"'), "'O' is no number", "name a key that holds one"),
    "no number, with values": (
        one('among = ["extreme", "30 deg"]', '"mechanism.input.joint"'),
        "'O' is no number",
        "name a key that holds one",
    ),
    "several keys": (one(RANGE, '"mechanism.links*"'), "may name several keys", "write each: of = [...]"),
    "drawn twice": (MORE + MORE, f"{CRANK} is drawn twice", "remove it from one of the tables"),
    "drawn twice, written otherwise": (
        MORE + one(RANGE, '"mechanism.links[0].points.A[0]"'),
        f"mechanism.links[0].points.A[0] is drawn twice, as {CRANK} too",
        "remove it from one of the tables",
    ),
    "two units": (one(RANGE, f'["{CRANK}", "{ROD}"]'), "'mm' and '': keys with one value", "two [[class.drawn]]"),
    "no step": (one('at_least = "80 mm"\nat_most = "120 mm"'), "missing key: step", "students get round numbers"),
    "a step of nothing": (one(RANGE.replace('"5 mm"', "0")), "a step of 0 goes nowhere", "write one above 0"),
    "too large a step": (one(RANGE.replace('"5 mm"', '"90 mm"')), "leaves the least value alone", "a smaller one"),
    "another kind": (one(RANGE.replace("120 mm", "120 kg")), "'120 kg' is no number in mm", "write it in mm"),
    "the wrong way round": (
        one(RANGE.replace("80 mm", "180 mm")),
        "'120 mm' is not above at_least",
        "widen the limits",
    ),
    "one limit": (
        one('at_least = "80 mm"\nstep = 5'),
        "missing key: at_most, between which it is drawn",
        "add at_least",
    ),
    "one value": (one('among = ["80 mm"]'), "one value leaves nothing to choose", "write two or more"),
    "a value twice": (one('among = ["80 mm", "8 cm"]'), "a value stands twice", "write each once"),
    "values and limits": (
        one(f'among = ["80 mm", "90 mm"]\n{RANGE}'),
        "step together with among",
        "remove one of them",
    ),
    "values and a factor": (
        one(f'among = [1, 2]\ntimes = "{ROD}"'),
        "among together with times",
        "remove one of them",
    ),
    "a factor of two": (
        one(f'times = ["{ROD}", "mechanism.fixed.C[0]"]\n{FACTORS}'),
        "one key is multiplied",
        "one key",
    ),
    "a factor of nothing": (one(f'times = "mechanism.links[id=8].mass"\n{FACTORS}'), "id = 8", "there are: 1, 2, 3"),
    "a factor of itself": (one(f'times = "{CRANK}"\n{FACTORS}'), "is multiplied to give itself", "name another key"),
    "a factor of what comes later": (
        one(f'times = "{CRANK}"\n{FACTORS}', f'"{ROD}"') + MORE,
        f"{CRANK} is drawn after what it multiplies to",
        "move its table before this one",
    ),
    "a factor with a unit": (
        MORE + one(f'times = "{CRANK}"\n{FACTORS.replace("3", chr(34) + "3 mm" + chr(34), 1)}', f'"{ROD}"'),
        "at_least = '3 mm' beside times is a factor",
        "write at_least = 3",
    ),
    "a factor below nothing": (
        MORE + one(f'times = "{CRANK}"\n{FACTORS.replace("3", "-3", 1)}', f'"{ROD}"'),
        "a factor of -3",
        "write one above 0",
    ),
    "one factor": (
        MORE + one(f'times = "{CRANK}"\nat_least = 3\nstep = "1 cm"', f'"{ROD}"'),
        "missing key: at_most, the factor of times",
        "add at_least = 3 and at_most = 4",
    ),
    "one name for two": (
        asked('omega_2@1"\nname = "w"', 'omega_3@2"\nname = "W"'),
        "'W' is the name of two asked results",
        "give one of them another name",
    ),
    "another name that is one": (
        asked('omega_2@1"\nname = "w"\nalso = ["kinematics.omega_3@1"]'),
        "'kinematics.omega_3@1' is the name of two asked results",
        "another name",
    ),
    "after what is not asked": (
        asked('omega_2@1"\nname = "omega_2"\nafter = ["omega2"]'),
        "no asked result is called 'omega2'",
        'did you mean "omega_2"? asked are: kinematics.omega_3@1, omega_2',
    ),
    "after itself": (asked('omega_2@1"\nname = "w2"\nafter = ["W2"]'), "computed from itself", "what comes before it"),
    "a circle": (
        asked('omega_2@1"\nname = "a"\nafter = ["b"]', 'omega_3@2"\nname = "b"\nafter = ["a"]'),
        "computed from itself",
        "what comes before it",
    ),
    "a power of nothing": (
        asked('omega_2@1"\nname = "a"', 'omega_3@2"\nname = "b"\nafter = ["a^0"]'),
        "'a^0': with the power 0",
        'write "a", or another power',
    ),
    "plans that are more accurate": (
        asked('omega_2@1"\nplans = "0.5 %"'),
        "plans within 0.5 % are more accurate than right answers, within 1 %",
        "make plans larger",
    ),
    "a tolerance above that of plans": (
        asked('omega_2@1"\nplans = 0.03\ntolerance = 0.04'),
        "plans within 3 % are more accurate than right answers, within 4 %",
        "or tolerance smaller",
    ),
    "a long name": (asked(f'omega_2@1"\nname = "{"w" * 81}"'), "longer than 80 characters", "write a shorter one"),
    "a name of two lines": (asked('omega_2@1"\nname = "w\\nw"'), "holds a line break", "write it on one line"),
    "a tolerance of all": (asked('omega_2@1"\ntolerance = 1'), "1 is out of range", "write a number"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_told_with_its_remedy(name: str) -> None:
    text, message, remedy = FAULTS[name]
    with pytest.raises(SpecError) as raised:
        parse_spec(f"{MECHANISM}\n{text}")
    told = str(raised.value)
    assert message in told
    assert remedy in told


def test_all_faults_are_told_at_once() -> None:
    with pytest.raises(SpecError) as raised:
        parse_spec(
            f"{MECHANISM}\n{one(RANGE.replace('5 mm', '0 mm'))}{asked('omega_2@1' + chr(34))[len(MORE) :]}after = ['x']"
        )
    assert len(raised.value.faults) == 2


def test_what_is_asked_may_be_after_another_by_any_of_its_names() -> None:
    text = asked('omega_2@1"\nname = "w2"\nalso = ["кутова швидкість"]', 'eps_2@1"\nafter = ["Кутова Швидкість"]')
    own = parse_spec(f"{MECHANISM}\n{text}").class_
    assert own is not None
    assert own.asked[2].after == ["Кутова Швидкість"]
