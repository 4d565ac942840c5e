"""The document of a rotor: its unbalance, corrections in one plane and in two, bearing loads, the balance quality."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.machine.balance.grades import EXAMPLES
from tmmcalc.machine.balance.rotors import RotorState, RotorVerdict
from tmmcalc.machine.balance.rotortask import BalancedRotor
from tmmcalc.machine.balance.weights import Weight
from tmmcalc.machine.facts.weights import direction
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import NOISE, number

STATES = ("as it is", "one plane", "two planes")


def rotor_document(result: BalancedRotor, title: str) -> Document:
    """Facts, and the table of the rotor as it is and after either balancing."""
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
    return Document(title, facts, tuple(_notes(result.grade)), _states_view(result))


def _peak(result: BalancedRotor) -> float:
    """What is noise against this unbalance [kg*m] is none."""
    return max(map(abs, (*result.balance.before.equivalent, *result.balance.moments)))


def _unbalance_facts(before: RotorState, peak: float) -> Iterator[Fact]:
    """The resultant with the shift of the centre of mass, and the couple."""
    text = _moment(before.resultant, peak)
    if not text.startswith("0 "):
        text += f", shift of the centre of mass {number(1e6 * before.eccentricity, 5)} um"
    values = {**_polar("U", "kg*m", before.resultant), "eccentricity[m]": before.eccentricity}
    yield Fact("unbalance", text, values)
    text = f"{_moment(before.couple, peak, 'g*mm^2', 1e9)}, about the centre of mass"
    yield Fact("unbalance couple", text, _polar("U_couple", "kg*m^2", before.couple))


def _moment(moment: complex, peak: float = 0.0, unit: str = "g*mm", factor: float = 1e6) -> str:
    """A static moment or couple with its direction; 0 if it is noise against ``peak``."""
    if abs(moment) <= NOISE * peak:
        return f"0 {unit}"
    return f"{number(factor * abs(moment), 6)} {unit} at {direction(cmath.phase(moment))} deg"


def _polar(key: str, unit: str, moment: complex) -> dict[str, float]:
    return {f"{key}[{unit}]": abs(moment), f"{key}_angle[deg]": math.degrees(cmath.phase(moment))}


def _correction_fact(
    label: str, key: str, moments: Sequence[tuple[float, complex]], weights: Sequence[Weight | None], peak: float
) -> Fact:
    """One line a plane: the static moment, and the mass that has it at the chosen radius."""
    lines, values = [], []
    for (z, moment), weight in zip(moments, weights, strict=True):
        line, found = (
            f"z = {number(1e3 * z)} mm: {_moment(moment, peak)}",
            {"z[m]": z, **_polar("moment", "kg*m", moment)},
        )
        if weight is not None:
            found |= {"mass[kg]": weight.mass, "radius[m]": weight.radius}
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
    values = {
        "grade[mm/s]": first.grade,
        "U_per[kg*m]": first.permissible,
        "U_per_A[kg*m]": first.allowed[0],
        "U_per_B[kg*m]": first.allowed[1],
    }
    yield Fact("balance quality", text, values)
    text = ", ".join(f"{state}: {'yes' if v.passed else 'no'}" for state, v in zip(STATES, grades, strict=True))
    kept = {f"grade_kept_{state.replace(' ', '_')}": v.passed for state, v in zip(STATES, grades, strict=True)}
    yield Fact("is it kept", text, kept)


def _legend(result: BalancedRotor) -> str:
    text = "e: shift of the centre of mass; A, B: loads of the bearings, which turn with the rotor"
    return f"{text}; A_part, B_part: unbalance in their planes over the allowed one" if result.grade else text


def _states_view(result: BalancedRotor) -> View:
    """One row a state."""
    states = (result.balance.before, result.balance.static, result.balance.dynamic)
    shifted = [abs(state.resultant) > NOISE * _peak(result) for state in states]
    shifts = [1e6 * state.eccentricity if any_ else 0.0 for state, any_ in zip(states, shifted, strict=True)]
    a, b = ([abs(state.loads[k]) for state in states] for k in range(2))
    columns: dict[str, list[Any]] = {"state": list(STATES), "e[um]": shifts, "A[N]": a, "B[N]": b}
    peaks = [0.0, 0.0, max(*a, *b), max(*a, *b)]
    if result.grade:
        columns["e omega[mm/s]"] = [v.value if any_ else 0.0 for v, any_ in zip(result.grade, shifted, strict=True)]
        for k, name in enumerate(("A_part[%]", "B_part[%]")):
            columns[name] = [100 * verdict.residual[k] / verdict.allowed[k] for verdict in result.grade]
        peaks += [0.0, 100.0, 100.0]
    return View(list(columns), list(columns.values()), peaks)


def _notes(grades: Sequence[RotorVerdict]) -> Iterator[str]:
    """What the grade asks for."""
    if not grades:
        return
    before, static, dynamic = grades
    name = f"G {before.grade:g}"
    if before.passed:
        yield f"note: the rotor keeps {name} as it is"
    elif static.passed:
        yield f"note: balancing in one plane is enough for {name}"
    elif dynamic.passed:
        yield f"note: balancing in one plane is not enough for {name}, it takes two"
