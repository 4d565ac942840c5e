"""The gear part of ``make bench``: complete searches, how their time grows with the limits, and their memory."""

from __future__ import annotations

import subprocess
import sys
from fractions import Fraction

import numpy as np
from timing import bar_text, median_time

from tmmcalc.gears.exact import around
from tmmcalc.gears.model import Demands, Limits, TrainTask
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.strength.series import eighths

SIMPLE, COMPOUND, WIDE = 50.0, 200.0, 1000.0  # ms
# layout, tooth ratio (of AII i_14), whether its modules are tied
TRAINS = (
    ("AIbar", "5", False),
    ("2A-AA", "4", False),
    ("AI", "20", True),
    ("AA", "8", True),
    ("II", "0.98", True),
    ("AII", "100", True),
    ("coaxial", "8", True),
)
CODE = """
import re, sys
sys.path[:0] = {path!r}
from bench_gears import task
from tmmcalc.gears.search.search import synthesise
{work}
print(re.search(r'VmHWM:\\s*(\\d+)', open('/proc/self/status').read())[1])
"""


def proportions() -> tuple[tuple[int, ...], ...]:
    """All m1 : m2 of standard modules from 1 to 2.5."""
    ratios = {Fraction(second, first) for first in eighths() for second in eighths()}
    return tuple((r.denominator, r.numerator) for r in sorted(ratios) if 1 <= r <= Fraction(5, 2))


def task(layout: str, ratio: str, tied: bool, largest: int = 150, every: bool = False) -> TrainTask:
    """1 % of the ratio, three planets, all constraints."""
    nominal = Fraction(ratio)
    parts = (proportions() if every else ((1, 1),)) if tied else ((1,),)
    limits = Limits(largest=largest, largest_ring=largest * 7 // 3)
    demands = Demands(undercut=17)
    return TrainTask(layout, nominal, around(nominal, Fraction("0.01"), relative=True), parts, 3, limits, demands)


def gears() -> list[str]:
    """Every branched layout: one proportion of modules and all, teeth to 150 and to 300; unfolded trains."""
    missed = []
    print("\ncomplete search of tooth numbers, 1 %, 3 planets           sets        time     bar")
    for layout, ratio, tied in TRAINS:
        for largest, every in ((150, False), (150, True), (300, False), (300, True)):
            if every and not tied:
                continue
            bar = WIDE if largest > 150 else COMPOUND if tied else SIMPLE
            work = task(layout, ratio, tied, largest, every)
            found = synthesise(work)
            ms = median_time(lambda work=work: synthesise(work), 0.2) * 1e3
            name = f"{layout}, z to {largest}, {len(work.proportions)} proportions of modules"
            print(f"  {name:<52} {found.count:8d} {ms:8.1f} ms  {bar_text(ms, bar)}")
            if ms > bar:
                missed.append(f"search {name}")
    _growth()
    return missed + _memory()


def _growth() -> None:
    sizes = np.array([75, 150, 300, 600])
    for layout, ratio, tied in TRAINS:
        works = [task(layout, ratio, tied, largest) for largest in sizes.tolist()]
        times = [median_time(lambda work=work: synthesise(work), 0.1) for work in works]
        slope = np.polyfit(np.log(sizes), np.log(times), 1)[0]
        print(f"  {layout:<8} time ~ z_max^{slope:.1f}")


def _memory() -> list[str]:
    """Peak memory of the largest search above that of a process that only imports it."""
    few, many = (
        int(subprocess.check_output([sys.executable, "-c", CODE.format(path=sys.path[:1], work=work)])) / 1024
        for work in ("", 'synthesise(task("II", "0.98", True, 300, True))')
    )
    bar = 300.0
    told = f"{many:.0f} MiB, of which {few:.0f} for imports"
    print(f"  peak memory, II, z to 300, all proportions: {told}  {bar_text(many, bar)}")
    return ["memory of the search"] if many > bar else []
