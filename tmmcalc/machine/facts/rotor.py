"""The document of a rotor: its unbalance, corrections in one plane and in two, bearing loads, the balance quality."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed, table
from tmmcalc.machine.balance.grades import EXAMPLES
from tmmcalc.machine.balance.rotors import RotorState, RotorVerdict
from tmmcalc.machine.balance.rotortask import BalancedRotor
from tmmcalc.machine.balance.weights import Weight
from tmmcalc.machine.facts.weights import DIRECTION, MOMENT, PLANE, direction, polar
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import NOISE, number

STATES = ("as it is", "one plane", "two planes")

UNBALANCE = Quantity("U[kg*m]", "resultant of the unbalances")
UNBALANCE_ANGLE = Quantity("U_angle[deg]", "direction of the resultant of the unbalances")
COUPLE_ANGLE = Quantity("U_couple_angle[deg]", "direction of the couple of the unbalances")
KEPT = Quantity("grade_kept_{plan}", "whether the balance quality grade is kept, {plan}")
COUPLE = Quantity("U_couple[kg*m^2]", "couple of the unbalances about the centre of mass")


def rotor_document(result: BalancedRotor, title: str, *, everything: bool = True) -> Document:
    """Facts, and the table of the rotor as it is and after either balancing; ``everything`` is all in SI."""
    balance = result.balance
    peak = _peak(result)
    one = [(balance.static_plane, balance.static_moment)]
    two = list(zip(balance.planes, balance.moments, strict=True))
    facts = (
        *_unbalance_facts(balance.before, peak),
        _correction_fact("one-plane weight", "static", one, [result.static], peak),
        _correction_fact("two-plane weights", "dynamic", two, result.dynamic or (None, None), peak),
        *_grade_facts(result.grade),
        Fact("columns", _legend(result)),
    )
    return Document(title, facts, tuple(_notes(result.grade)), _states_view(result, everything))


def _peak(result: BalancedRotor) -> float:
    """What is noise against this unbalance [kg*m] is none."""
    return max(map(abs, (*result.balance.before.equivalent, *result.balance.moments)))


def _unbalance_facts(before: RotorState, peak: float) -> Iterator[Fact]:
    """The resultant with the shift of the centre of mass, and the couple."""
    text = _moment(before.resultant, peak)
    if not text.startswith("0 "):
        text += f", shift of the centre of mass {number(1e6 * before.eccentricity, 5)} um"
    values = {**polar(UNBALANCE, UNBALANCE_ANGLE, before.resultant), **keyed(before, "eccentricity")}
    yield Fact("unbalance", text, values)
    text = f"{_moment(before.couple, peak, 'g*mm^2', 1e9)}, about the centre of mass"
    yield Fact("unbalance couple", text, polar(COUPLE, COUPLE_ANGLE, before.couple))


def _moment(moment: complex, peak: float = 0.0, unit: str = "g*mm", factor: float = 1e6) -> str:
    """A static moment or couple with its direction; 0 if it is noise against ``peak``."""
    if abs(moment) <= NOISE * peak:
        return f"0 {unit}"
    return f"{number(factor * abs(moment), 6)} {unit} at {direction(cmath.phase(moment))} deg"


def _correction_fact(
    label: str, key: str, moments: Sequence[tuple[float, complex]], weights: Sequence[Weight | None], peak: float
) -> Fact:
    """One line a plane: the static moment, and the mass that has it at the chosen radius."""
    lines, values = [], []
    for (z, moment), weight in zip(moments, weights, strict=True):
        line, found = (
            f"z = {number(1e3 * z)} mm: {_moment(moment, peak)}",
            {**PLANE.value(z), **polar(MOMENT, DIRECTION.of(name="moment_"), moment)},
        )
        if weight is not None:
            found |= keyed(weight, "mass", "radius")
            if abs(moment) > NOISE * peak:
                line += f": {_mass(weight.mass)} at {number(1e3 * weight.radius)} mm"
        lines.append(line)
        values.append(found)
    return Fact(label, "\n".join(lines), {f"correction_{key}": values})


def _mass(kg: float) -> str:
    return f"{number(kg, 5)} kg" if kg >= 1 else f"{number(1e3 * kg, 5)} g"


def _grade_facts(grades: Sequence[RotorVerdict]) -> Iterator[Fact]:
    """What the grade allows, and whether each state keeps it."""
    if not grades:
        return
    first = grades[0]
    machines = f", for {EXAMPLES[first.grade]}" if first.grade in EXAMPLES else ""
    allowed = [f"{number(1e6 * value, 5)} g*mm" for value in (first.permissible, *first.allowed)]
    text = f"G {first.grade:g}{machines}\nallows {allowed[0]}: {allowed[1]} in plane A, {allowed[2]} in B"
    yield Fact("balance quality", text, keyed(first, "grade", "permissible", "allowed_a", "allowed_b"))
    text = ", ".join(f"{state}: {'yes' if v.passed else 'no'}" for state, v in zip(STATES, grades, strict=True))
    kept = {KEPT.of(plan=state.replace(" ", "_")).key: v.passed for state, v in zip(STATES, grades, strict=True)}
    yield Fact("is it kept", text, kept)


def _legend(result: BalancedRotor) -> str:
    text = "e: shift of the centre of mass; A, B: loads of the bearings, which turn with the rotor"
    return f"{text}; A_part, B_part: unbalance in their planes over the allowed one" if result.grade else text


def _states_view(result: BalancedRotor, everything: bool) -> View:
    """One row a state; for people the shift of the centre of mass in um."""
    shift = "eccentricity" if everything else "eccentricity[um]"
    states = (result.balance.before, result.balance.static, result.balance.dynamic)
    shifted = [abs(state.resultant) > NOISE * _peak(result) for state in states]
    loads = table(states, RotorState, "load_a", "load_b")
    columns = {"state": list(STATES), **_noiseless(table(states, RotorState, shift), shifted), **loads}
    largest = max(value for load in loads.values() for value in load)
    peaks = [0.0, 0.0, largest, largest]
    if result.grade:
        columns |= _noiseless(table(result.grade, RotorVerdict, "value"), shifted)
        columns |= table(result.grade, RotorVerdict, "part_a", "part_b")
        peaks += [0.0, 100.0, 100.0]
    return View(list(columns), list(columns.values()), peaks)


def _noiseless(columns: dict[str, list[Any]], shifted: Sequence[bool]) -> dict[str, list[Any]]:
    """Columns with 0 of the states whose centre of mass is not ``shifted`` but for rounding."""
    return {
        header: [value if any_ else 0.0 for value, any_ in zip(values, shifted, strict=True)]
        for header, values in columns.items()
    }


def _notes(grades: Sequence[RotorVerdict]) -> Iterator[str]:
    """What the grade asks for."""
    if not grades:
        return
    before, static, dynamic = grades
    name = f"G {before.grade:g}"
    if before.passed:
        yield Phrase("note: the rotor keeps {name} as it is", name=name)
    elif static.passed:
        yield Phrase("note: balancing in one plane is enough for {name}", name=name)
    elif dynamic.passed:
        yield Phrase("note: balancing in one plane is not enough for {name}, it takes two", name=name)
