"""The laws by phase for a note: what they are multiplied by, their constants and peaks, the coefficients of pieces."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees
from typing import Any

from tmmcalc.cams.facts.cam_law import constants_fact
from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.laws.details import PhaseLaw, RockerPhase, StemPhase
from tmmcalc.core.quantity import in_degrees, keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number

PIECES = "note: s = c0 + c1 t + c2 t^2 + ... + A sin(w t + p) on every piece, t = k less its begin"
Laws = Mapping[str, tuple[PhaseLaw, StemPhase | RockerPhase]]


def constants_document(result: LawResult, laws: Laws, title: str, *, everything: bool = False) -> Document:
    """The laws of the moving phases; the table has a row a piece, ``everything`` is all values by phase."""
    facts = []
    for phase in result.phases:
        if phase.constants is not None:
            law, motion = laws[phase.kind]
            values: dict[str, Any] = {phase.kind: in_degrees(keyed(law) | keyed(motion))}
            facts += [constants_fact(phase.kind, phase.constants), _scales_fact(phase.kind, law, motion, values)]
            facts.append(_peaks_fact(phase.kind, motion))
    pieces = _pieces_view({kind: law for kind, (law, _) in laws.items()})
    return Document(title, tuple(facts), (PIECES,), None if everything else pieces)


def _scales_fact(kind: str, law: PhaseLaw, motion: StemPhase | RockerPhase, values: dict[str, Any]) -> Fact:
    """What the derivatives by k are multiplied by."""
    told = [(quantity_of(type(motion), name).name, getattr(motion, name)) for name in ("m1", "m2", "m3")]
    text = ", ".join(f"{name} = {_size(motion, value)}" for name, value in told)
    return Fact(f"scales, {kind}", f"{text} at phi_i = {angle(degrees(law.angle))} deg", values)


def _peaks_fact(kind: str, motion: StemPhase | RockerPhase) -> Fact:
    """Peaks of the phase with their places, in time where the speed is known."""
    lines = []
    for name, timed in (("slope", "velocity"), ("most", "speeding"), ("least", "slowing")):
        told, in_time = quantity_of(type(motion), name), quantity_of(type(motion), timed)
        at = angle(degrees(getattr(motion, f"{name}_at")))
        line = f"{told.name} = {_size(motion, getattr(motion, name))} at phi = {at} deg"
        value = getattr(motion, timed)
        lines.append(line if value is None else f"{line}: {number(value, 6)} {in_time.unit}")
    return Fact(f"peaks, {kind}", "\n".join(lines))


def _size(motion: StemPhase | RockerPhase, value: float) -> str:
    return number(value, 6) if isinstance(motion, RockerPhase) else f"{number(1e3 * value, 6)} mm"


def _pieces_view(laws: Mapping[str, PhaseLaw]) -> View:
    """A row a piece."""
    rows: list[dict[str, Any]] = []
    width = max(law.coefficients.shape[1] for law in laws.values())
    waves = any(law.amplitude.any() for law in laws.values())
    for phase, law in laws.items():
        for i, row in enumerate(law.coefficients.tolist()):
            each: dict[str, Any] = {"phase": phase, "k from": float(law.breaks[i]), "k to": float(law.breaks[i + 1])}
            each |= {f"c{power}": value for power, value in enumerate([*row, *[0.0] * (width - len(row))])}
            if waves:
                wave = keyed(law, "amplitude", "frequency", "lead")
                each |= {key: values[i] for key, values in wave.items()}
            rows.append(each)
    return View(list(rows[0]), [[row[header] for row in rows] for header in rows[0]])
