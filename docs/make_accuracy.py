"""Write docs/accuracy.md and its diagrams: ``make accuracy``.

Every number is measured here and now: times are those of the machine that runs it, errors are the same everywhere.
"""

from __future__ import annotations

from pathlib import Path

from tmmcalc import load_spec
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import Accuracy, Study, pareto
from tmmcalc.report.accuracy import called
from tmmcalc.report.pictures import draw_accuracy

HOME = Path(__file__).parent
ROOT = HOME.parent
SCENES = {
    "shaper": "Shaper: crank and slotted link, with its motor",
    "press": "Press: crank and toggle",
    "elastic-drive": "Press with an elastic drive: start and braking",
    "gears-pairs": "Pairs of gears",
    "gears-single-planets": "Planetary train",
    "cam-translating": "Cam with a translating roller follower",
}
TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)
HEAD = """# Accuracy

Every method that the program has for a stage, with its error against a reference and its run time, on ready specs.
Errors are the largest over all positions, relative to the largest magnitude of the quantity. The reference of each
study is proved better than what it judges: it says how, and its own error. Times are medians on two shared cores;
their ratios are what matters. `make accuracy` writes this page afresh, `tmmcalc accuracy my.toml` does it for a spec.
"""


def page() -> str:
    """The whole document; the diagrams are written on the way."""
    return "\n".join((HEAD, *(_scene(name, heading) for name, heading in SCENES.items())))


def _scene(name: str, heading: str) -> str:
    result = solve_accuracy(load_spec(ROOT / "configs" / f"{name}.toml"), clock=Clock(repeats=9, budget=1.0))
    picture = HOME / "accuracy" / f"{name}.svg"
    picture.parent.mkdir(exist_ok=True)
    draw_accuracy(result, picture, heading)
    told = [f"## {heading}\n", f"`configs/{name}.toml`\n", f"![error over run time](accuracy/{name}.svg)\n"]
    return "\n".join((*told, _orders(result), *(_study(study) for study in result.studies)))


def _orders(result: Accuracy) -> str:
    """Orders of convergence that are known and were observed."""
    known = [
        f"| {study.stage} | {study.quantity} | {series.method} | {series.expected:.3g} | "
        + ("" if series.order is None else f"{series.order:.2f}")
        + " |"
        for study in result.studies
        for series in study.series
        if series.expected is not None
    ]
    if not known:
        return ""
    return "\n".join(
        ("| stage | quantity | method | order by theory | observed |", "|---|---|---|---|---|", *known, "")
    )


def _study(study: Study) -> str:
    """The front of a study: what no other setting beats in both error and time."""
    points = [point for series in study.series for point in series.points]
    best = {id(point): series for series in study.series for point in series.points}
    rows = [
        f"| {called(best[id(point)], point)} | {point.error:.1e} | {(point.seconds or 0.0) * 1e3:.3g} |"
        for point in pareto(points)
    ]
    reference = f"Reference: {study.reference.name}, error {study.reference.error:.1e}. {_cheapest(study)}"
    return "\n".join(
        (f"### {study.stage}: {study.quantity}\n", reference, "", "| best of all | error | time, ms |", "|---|---|---|",
         *rows, "")
    )  # fmt: skip


def _cheapest(study: Study) -> str:
    missed = [f"{tolerance:.0e}" for tolerance in TOLERANCES if study.cheapest(tolerance) is None]
    return f"No method reaches {', '.join(missed)}." if missed else ""


if __name__ == "__main__":
    (HOME / "accuracy.md").write_text(page(), encoding="utf-8")
