"""The documents of the transloader: speeds with their limits, loads by case, stresses of its parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tmmcalc.core.quantity import keyed, keys, table
from tmmcalc.extras.loadcases import CASES, LOADS, PARTS_OF_MASS
from tmmcalc.extras.transloader import MINUTE, Acting, Check, Drive, Limit, Transloader
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

FACTORS = {"sum": "K_m = K1 + K2 (sum, as printed)", "product": "K_m = K1 K2 (product)"}


def summary(result: Transloader, title: str) -> Document:
    """Capacity, speeds, limits, loads, the part that is most strained."""
    return Document(title, tuple(_facts(result)), result.notes)


def document(result: Transloader, title: str, *, everything: bool = False) -> Document:
    """The summary with the stresses of the parts as a table, for programs in SI."""
    return replace(summary(result, title), table=_checks(result, everything) if result.checks else None)


def _facts(result: Transloader) -> Iterator[Fact]:
    yield Fact("capacity", f"{number(result.capacity / 1000)} t", keyed(result, "capacity"))
    if result.masses:
        text = ", ".join(
            f"{name} {number(mass / 1000)} t" for name, mass in zip(PARTS_OF_MASS, result.masses, strict=True)
        )
        yield Fact("usual masses", text, keyed(result, "masses"))
    for drive in result.drives:
        yield Fact(drive.what, _way(drive), {drive.what: keyed(drive)})
    if result.limits:
        limits = [keyed(each, unit=each.unit, what=each.what) for each in result.limits]
        yield Fact("limits", "\n".join(map(_limit, result.limits)), {"limits": limits})
    if result.inertia is not None:
        yield Fact("force of inertia", f"P = {number(result.inertia / 1000)} kN", keyed(result, "inertia"))
    cases = "\n".join(f"{case}: {meaning}" for case, meaning in CASES.items())
    yield Fact("cases", cases, {"cases": dict(CASES)})
    lines = "\n".join(_acting(each, result.blanks) for each in result.loads)
    yield Fact("loads", lines, {"loads": [keyed(each) for each in result.loads], **keyed(result, "blanks")})
    if result.checks:
        worst = max(result.checks, key=lambda each: each.use)
        yield Fact("factor K_m", FACTORS[result.factors], keyed(result, "factors"))
        yield Fact(
            "most strained",
            f"{worst.part}, case {worst.case}: {number(worst.stress / 1e6)} MPa of {number(worst.allowed / 1e6)} MPa "
            f"({worst.kind}), {number(100 * worst.use, 4)} %",
            {"worst": keyed(worst)},
        )


def _way(drive: Drive) -> str:
    """Speeds in m/min, as the source has them."""
    peak, speed = (f"{number(MINUTE * v)} m/min" for v in (drive.peak, drive.speed))
    return (
        f"peak sqrt(L j) = {number(drive.peak)} m/s = {peak}; v = {number(drive.speed)} m/s = {speed}, "
        f"{number(drive.time)} s for {number(drive.length)} m (at the peak {number(drive.shortest)} s)"
    )


def _limit(limit: Limit) -> str:
    scale, unit = (MINUTE, "m/min") if limit.unit == "m/s" else (1.0, limit.unit)
    low, high = (None if end is None else number(scale * end) for end in (limit.low, limit.high))
    between = f"at most {high}" if low is None else f"at least {low}" if high is None else f"{low} to {high}"
    return f"{limit.what}: {number(scale * limit.value)} {unit}, {between}{'' if limit.holds else ': NOT KEPT'}"


def _acting(load: Acting, blanks: str) -> str:
    where = ", ".join(load.cases) or "in none"
    blank = f" ({', '.join(load.blank)} blank in the source: {blanks} it)" if load.blank else ""
    return f"{LOADS[load.load].meaning}: {number(load.value / 1000)} kN in {where}{blank}"


def _checks(result: Transloader, everything: bool) -> View:
    """A row a part and a case, stresses in Pa or, for people, in MPa."""
    unit = "" if everything else "[MPa]"
    names = ("part", "case", "kind", f"stress{unit}", "importance", "duty", "margin", "making", f"allowed{unit}")
    columns = table(result.checks, Check, *names, f"other{unit}", "use")
    holds = ["yes" if each.holds else "NO" for each in result.checks]
    return View([*columns, *keys(Check, "holds")], [*columns.values(), holds])
