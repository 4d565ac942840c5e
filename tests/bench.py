"""``make bench``: start-up as ratios, kinematics in one process, growth and memory, in one run on one machine.

Commands are timed as whole processes, in turn with their yardstick (A B A B ...), and compared pair by pair, so the
ratio holds when the machine's speed drifts. The bars are those of the design; a bar that is missed is marked.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import numpy as np
from random_mechanisms import build

import tmmcalc
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.results import Trace
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.trace import trace
from tmmcalc.spec.linkage import to_linkage

SHAPER = Path(__file__).parent.parent / "configs" / "shaper.toml"
ROUNDS = 15
YARDSTICK_HELP = "import typer"
YARDSTICK_RUN = "import numpy, typer, pydantic, rich.table"
# the same libraries not only imported but used once: pydantic and typer load most of themselves at first use
LEAST_RUN = """
import sys, numpy, typer
from typing import Annotated
from pydantic import BaseModel
class Table(BaseModel):
    key: int = 1
app = typer.Typer(add_completion=False)
@app.command()
def command(file: Annotated[str, typer.Argument()], quiet: Annotated[bool, typer.Option("-q")] = False) -> None:
    print(Table.model_validate({"key": 2}))
app(["x"])
"""


def main() -> None:
    """Print all tables."""
    missed = [*startup(), *kinematics()]
    growth()
    memory()
    print(f"\n{len(missed)} bars missed{': ' if missed else ''}{'; '.join(missed)}")


def startup() -> list[str]:
    """Whole commands against the import of the libraries that they cannot do without."""
    print(f"start-up, medians of {ROUNDS} pairs         command  yardstick   ratio     bar")
    with tempfile.TemporaryDirectory() as folder:
        program = [sys.executable, "-m", "tmmcalc"]
        run = [*program, "kinematics", str(SHAPER), "-o", folder, "--quiet"]
        return [
            *_pair("tmmcalc --help", [*program, "--help"], YARDSTICK_HELP, 1.5),
            *_pair("tmmcalc kinematics shaper, computed", [*run, "--fresh"], YARDSTICK_RUN, 1.4),
            *_pair("tmmcalc kinematics shaper, loaded", run, YARDSTICK_RUN, 1.4),
            *_pair("least command of these libraries", [sys.executable, "-c", LEAST_RUN], YARDSTICK_RUN, None),
        ]


def _pair(name: str, command: list[str], yardstick: str, bar: float | None) -> list[str]:
    other = [sys.executable, "-c", yardstick]
    for argv in (command, other):
        _process(argv)
    pairs = [(_process(command), _process(other)) for _ in range(ROUNDS)]
    ours, theirs = (statistics.median(column) * 1e3 for column in zip(*pairs, strict=True))
    ratio = statistics.median(a / b for a, b in pairs)
    print(f"  {name:<36} {ours:6.0f} ms  {theirs:6.0f} ms  {ratio:6.2f}  {_bar(ratio, bar) if bar else ''}")
    return [name] if bar and ratio > bar else []


def _process(argv: list[str]) -> float:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    start = perf_counter()
    subprocess.run(argv, check=True, stdout=subprocess.DEVNULL, env=environment)
    return perf_counter() - start


def _bar(value: float, bar: float) -> str:
    return f"{bar:6g} {'' if value <= bar else 'MISSED'}"


def _time(work: Callable[[], object], least: float = 0.4) -> float:
    """Median seconds of one call, over at least 5 calls and ``least`` seconds."""
    work()
    times: list[float] = []
    while len(times) < 5 or sum(times) < least:
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return statistics.median(times)


def _shaper() -> Chain:
    mechanism = to_linkage(tmmcalc.load_spec(SHAPER).mechanism)
    return compile_chain(mechanism, solve_structure(mechanism), {})


def kinematics() -> list[str]:
    """A six-bar of two dyads: velocities and accelerations of all links and points, stacked."""
    chain = _shaper()
    missed = []
    print("\nsix-bar, velocities and accelerations of all links and points, and the transfer functions")
    print("                               time      per position     bar")
    for n, bar in ((360, 0.3), (3_600, None), (36_000, 8.0), (360_000, None)):
        x = np.linspace(0.0, 2 * np.pi, n)
        ms = _time(lambda x=x: _in_time(trace(chain, x))) * 1e3
        print(f"  {n:>7} positions           {ms:8.3f} ms  {ms / n * 1e6:8.1f} ns  {_bar(ms, bar) if bar else ''}")
        if bar and ms > bar:
            missed.append(f"six-bar at {n}")
    spec = tmmcalc.load_spec(SHAPER)
    ms = _time(lambda: tmmcalc.solve_kinematics(spec)) * 1e3
    print(f"  whole stage, 24 positions    {ms:8.3f} ms  (structure, assembly intervals, extremes, error estimate)")
    return missed


def _in_time(t: Trace, speed: float = 5.76) -> list[np.ndarray]:
    """Time derivatives of everything, as a result gives them."""
    pairs = ((t.dr, t.ddr), (t.dangle, t.ddangle), (t.ds, t.dds))
    return [scaled for rate, rate2 in pairs for scaled in (rate * speed, rate2 * speed**2)]


def growth() -> None:
    """Time against the number of positions and of dyads: both must be linear."""
    chain = _shaper()
    sizes = np.array([4_000, 16_000, 64_000, 256_000])
    times = [_time(lambda n=n: trace(chain, np.linspace(0.0, 6.2, n))) for n in sizes]
    slope = np.polyfit(np.log(sizes), np.log(times), 1)[0]
    print(f"\ngrowth with positions: time ~ n^{slope:.2f}")
    kinds = ("RRR", "RRP", "RPR", "RRP")
    counts, spent = np.array([1, 2, 4, 8, 16]), []
    for count in counts:
        scene = build(np.random.default_rng(7), [kinds[k % 4] for k in range(count)], prismatic_input=False)
        mechanism = scene.mechanism
        x = np.full(3_600, mechanism.input.start)
        long_chain = compile_chain(mechanism, solve_structure(mechanism), {})
        with np.errstate(invalid="ignore"):
            spent.append(_time(lambda c=long_chain, x=x: trace(c, x)) * 1e3)
    line = np.polyfit(counts, spent, 1)
    print(
        "growth with dyads, 3 600 positions: "
        + ", ".join(f"{c}: {t:.2f} ms" for c, t in zip(counts, spent, strict=True))
    )
    print(f"  {line[0]:.3f} ms a dyad + {line[1]:.3f} ms")


def memory() -> None:
    """Peak memory of a child process that evaluates many positions, above that of one that evaluates few.

    Read from the kernel's own mark: the usual ``ru_maxrss`` of a child starts at the size of its parent.
    """
    code = (
        "import re, numpy as np, tmmcalc\n"
        "from tmmcalc.linkage.chain import compile_chain\n"
        "from tmmcalc.linkage.trace import Trace, trace\n"
        "from tmmcalc.spec.linkage import to_linkage\n"
        "m = to_linkage(tmmcalc.load_spec({file!r}).mechanism)\n"
        "c = compile_chain(m, tmmcalc.solve_structure(m), {{}})\n"
        "t = trace(c, np.linspace(0, 6.2, {n}))\n"
        "print(re.search(r'VmHWM:\\s*(\\d+)', open('/proc/self/status').read())[1])"
    )
    few, many = (
        int(subprocess.check_output([sys.executable, "-c", code.format(n=n, file=str(SHAPER))])) / 1024
        for n in (360, 360_000)
    )
    print(f"\npeak memory: {few:.0f} MiB at 360 positions, {many:.0f} MiB at 360 000", end="")
    print(f" ({(many - few) * 2**20 / 360_000:.0f} bytes a position)")


if __name__ == "__main__":
    main()
