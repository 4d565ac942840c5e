"""Write docs/accuracy.md and its diagrams: ``make accuracy``.

What is measured, times on the machine that runs it and errors, which are the same everywhere, is kept in
docs/accuracy/NAME.json; page and diagrams are drawn from there.

    make_accuracy.py                 measure all scenes, then draw
    make_accuracy.py press shaper    measure these alone, then draw
    make_accuracy.py --draw          draw from what is kept
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from tmmcalc import load_spec
from tmmcalc.accuracy.document import TOLERANCES, called, told
from tmmcalc.accuracy.picture import accuracy_drawing
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.core.atomic import replace_file
from tmmcalc.core.conversion import plain, restore
from tmmcalc.core.studies.measure import Clock
from tmmcalc.core.studies.study import Accuracy, Ladder, Series, Study
from tmmcalc.report.drawing import written

HOME = Path(__file__).parent
ROOT, DATA = HOME.parent, HOME / "accuracy"
SCENES = {
    "shaper": "Shaper: crank and slotted link, with its motor",
    "press": "Press: crank and toggle",
    "elastic-drive": "Press with an elastic drive: start and braking",
    "gears-pairs": "Pairs of gears",
    "gears-single-planets": "Planetary train",
    "cam-translating": "Cam with a translating roller follower",
}
DRAW = "--draw"
MIDDLE = 1e-6  # tolerance for which the methods are named that never reach it
ABOVE = 0.25  # part of the order by theory that the observed one may lack without a word
SETTLED = "Without a choice of methods in this scene:"
HEAD = """# Accuracy

Every method that the program has for a stage, with its error against a reference and its run time, on ready specs.
Errors are the largest over all positions, relative to the largest magnitude of the quantity. The reference of each
study says how it was found, and its own error. The best of all are those settings that no other beats in both time and
the error that they and all finer ones of their method keep. Times are medians on {cores} cores;
their ratios are what matters. `make accuracy` writes this page afresh, `tmmcalc accuracy my.toml` does it for a spec.
"""


def measure(name: str, clock: Clock) -> Accuracy:
    """All studies of a scene, run now; they are kept."""
    spec = load_spec(ROOT / "configs" / f"{name}.toml")
    result = replace(solve_accuracy(spec, clock=clock, tell=_tell), failures={})
    kept = {"cores": os.cpu_count(), "measured": plain(result)}
    replace_file(DATA / f"{name}.json", (json.dumps(kept, separators=(",", ":")) + "\n").encode())
    return result


def kept(name: str) -> tuple[int, Accuracy]:
    """Cores of the machine that measured a scene, and what it measured; raises `SystemExit` if nothing is kept."""
    file = DATA / f"{name}.json"
    if not file.exists():
        raise SystemExit(f"nothing is kept of {name}: run {Path(__file__).name} {name}")
    found = json.loads(file.read_text(encoding="utf-8"))
    return found["cores"], restore(Accuracy, found["measured"])


def page() -> str:
    """The whole document from what is kept; the diagrams are written on the way."""
    found = {name: kept(name) for name in SCENES}
    cores = sorted({cores for cores, _ in found.values()})
    parts = [_scene(name, SCENES[name], result) for name, (_, result) in found.items()]
    return "\n".join((HEAD.format(cores=" or ".join(map(str, cores))), *parts))


def _scene(name: str, heading: str, result: Accuracy) -> str:
    replace_file(DATA / f"{name}.svg", written("svg", accuracy_drawing(result, heading)))
    begun = [f"## {heading}\n", f"`configs/{name}.toml`\n", f"![error over run time](accuracy/{name}.svg)\n"]
    parts = [_study(study) for study in result.studies] + [_ladder(ladder) for ladder in result.ladders]
    settled = [f"{SETTLED} {', '.join(result.settled)}.\n"] if result.settled else []
    return "\n".join((*begun, *settled, _orders(result), *parts))


def _tell(words: str) -> None:
    print(words, file=sys.stderr)


def _orders(result: Accuracy) -> str:
    """Orders of convergence that are known and were observed, and why one is lower than that of theory."""
    rows = list(_rows(result))
    if not rows:
        return ""
    head = ("| stage | quantity | method | order by theory | observed | |", "|---|---|---|---|---|---|")
    return "\n".join((*head, *rows, ""))


def _rows(result: Accuracy) -> Iterator[str]:
    for study in result.studies:
        for series in study.series:
            if series.expected is not None and series.order is not None:
                why = series.note if _lacks(series) else ""
                orders = f"{series.expected:.3g} | {series.order:.2f} | {why} |"
                yield f"| {study.stage} | {study.quantity} | {series.method} | {orders}"


def _lacks(series: Series) -> bool:
    return (series.order or 0.0) < (1 - ABOVE) * (series.expected or 0.0)


def _study(study: Study) -> str:
    """The front of a study: what no other setting beats in both error and time."""
    rows = [
        f"| {called(series, point)} | {kept:.1e} | {(point.seconds or 0.0) * 1e3:.3g} |"
        for series, point, kept in study.front
    ]
    reference = f"Reference: {study.reference.name}, error {study.reference.error:.1e}."
    words = " ".join((reference, *_missed(study)))
    return "\n".join(
        (f"### {study.stage}: {study.quantity}\n", words, "", "| best | error kept | time, ms |", "|---|---|---|",
         *rows, "")
    )  # fmt: skip


def _missed(study: Study) -> Iterator[str]:
    """Tolerances that no method keeps, and the methods that come to none of the middle one."""
    missed = [told(tolerance) for tolerance in TOLERANCES if study.cheapest(tolerance) is None]
    if missed:
        yield f"No method keeps {', '.join(missed)}."
    never = [series.method for series in study.series if series.cheapest(MIDDLE) is None]
    if never and len(never) < len(study.series):
        yield f"No setting keeps {told(MIDDLE)} of: {', '.join(never)}."


def _ladder(ladder: Ladder) -> str:
    """What the textbook's fixed step would take on every rung beside the program's choice."""
    rows = [
        f"| {rung.value:.0e} | {rung.limit:.1e} | {rung.textbook_evaluations} | {rung.method} | {rung.evaluations} | "
        f"{rung.error:.1e} |"
        for rung in ladder.rungs
    ]
    reference = f"Reference: {ladder.reference.name}, error {ladder.reference.error:.1e}."
    head = f"| {ladder.unit} | limit of the step, s | evaluations at it | choice of the program | evaluations | error |"
    return "\n".join(
        (
            f"### {ladder.stage}, ladder: {ladder.quantity}\n",
            reference,
            "",
            head,
            "|---|---|---|---|---|---|",
            *rows,
            "",
        )
    )


def main(asked: Sequence[str]) -> None:
    """Measure the scenes that are asked for, all without a name, none with ``--draw``; then draw."""
    strange = [name for name in asked if name not in (*SCENES, DRAW)]
    if strange:
        raise SystemExit(f"no scene {', '.join(strange)}: scenes are {', '.join(SCENES)}")
    for name in [name for name in asked if name != DRAW] or ([] if DRAW in asked else SCENES):
        measure(name, Clock(repeats=9, budget=1.0))
    replace_file(HOME / "accuracy.md", page().encode())


if __name__ == "__main__":
    main(sys.argv[1:])
