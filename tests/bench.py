"""``make bench``: start-up as ratios, stages in one process, growth and memory, in one run on one machine.

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
from typing import Any

import numpy as np
from bench_batch import batches
from bench_cams import cams
from bench_gears import gears
from bench_page import pages
from bench_pairs import pairs
from by_hand import shaper
from random_mechanisms import build
from timing import bar_text, median_time

import tmmcalc
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.listing import list_assemblies
from tmmcalc.linkage.results import Trace
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.trace import trace
from tmmcalc.machine.driver import driver_of
from tmmcalc.machine.flywheel.required import required_inertia
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.machine.steady import driven
from tmmcalc.machine.tables.tasks.machine import to_gears, to_motor
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.scenario import LoadStep, Scenario
from tmmcalc.machine.transient.simulate import simulate

CONFIGS = Path(__file__).parent.parent / "configs"
SHAPER = CONFIGS / "shaper.toml"
PROJECT = CONFIGS / "course-project.toml"
ROUNDS = 15
SPEED = 5.76  # of the six-bar [rad/s]
SHORT = 0.1  # [s] that one of a pair of times is taken for
YARDSTICK_HELP = "import typer"
# the libraries of a command not only imported but used once: pydantic and typer load most of themselves at first use
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
    rooms = (startup, kinematics, forces, higher, machine, project, gears, pairs, cams, batches, pages)
    missed = [name for room in rooms for name in room()]
    growth()
    memory()
    print(f"\n{len(missed)} bars missed{': ' if missed else ''}{'; '.join(missed)}")


def startup() -> list[str]:
    """Whole commands against the least one that uses the libraries that they cannot do without."""
    print(f"start-up, medians of {ROUNDS} pairs               command  yardstick   ratio     bar")
    with tempfile.TemporaryDirectory() as folder:
        program = [sys.executable, "-m", "tmmcalc"]
        run = [*program, "kinematics", str(SHAPER), "-o", folder, "--quiet"]
        whole = [*program, "run", str(PROJECT), "-o", f"{folder}/project", "--quiet"]
        return [
            *_pair("tmmcalc --help", [*program, "--help"], YARDSTICK_HELP, 1.5),
            *_pair("tmmcalc kinematics shaper, computed", [*run, "--fresh"], LEAST_RUN, 1.2),
            *_pair("tmmcalc kinematics shaper, loaded", run, LEAST_RUN, 1.2),
            *_pair("tmmcalc run course-project, nothing to do", whole, LEAST_RUN, 2.0),
        ]


def _pair(name: str, command: list[str], yardstick: str, bar: float) -> list[str]:
    other = [sys.executable, "-c", yardstick]
    for argv in (command, other):
        _process(argv)
    pairs = [(_process(command), _process(other)) for _ in range(ROUNDS)]
    ours, theirs = (statistics.median(column) * 1e3 for column in zip(*pairs, strict=True))
    ratio = statistics.median(a / b for a, b in pairs)
    print(f"  {name:<42} {ours:6.0f} ms  {theirs:6.0f} ms  {ratio:6.2f}  {bar_text(ratio, bar)}")
    return [name] if ratio > bar else []


def _process(argv: list[str]) -> float:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    start = perf_counter()
    subprocess.run(argv, check=True, stdout=subprocess.DEVNULL, env=environment)
    return perf_counter() - start


def _shaper() -> Chain:
    mechanism = to_linkage(tmmcalc.load_spec(SHAPER).linkage)
    return compile_chain(mechanism, solve_structure(mechanism), {})


def kinematics() -> list[str]:
    """A six-bar of two dyads: velocities and accelerations of all links and points, beside numpy for it alone."""
    chain = _shaper()
    missed = []
    print("\nsix-bar, velocities and accelerations of all links and points, and the transfer functions")
    print("                               time      per position   by hand     ratio     bar")
    for n, bar in ((360, 2.0), (3_600, None), (36_000, 3.0), (360_000, None)):
        x = np.linspace(0.0, 2 * np.pi, n)
        pairs = [
            (
                median_time(lambda x=x: _in_time(trace(chain, x)), SHORT),
                median_time(lambda x=x: shaper(x, SPEED), SHORT),
            )
            for _ in range(5)
        ]
        ours, theirs = (statistics.median(column) * 1e3 for column in zip(*pairs, strict=True))
        ratio = statistics.median(a / b for a, b in pairs)
        told = f"{ours:8.3f} ms  {ours / n * 1e6:8.1f} ns  {theirs:8.3f} ms  {ratio:6.2f}"
        print(f"  {n:>7} positions           {told}  {bar_text(ratio, bar) if bar else ''}")
        if bar and ratio > bar:
            missed.append(f"six-bar at {n}")
    spec = tmmcalc.load_spec(SHAPER)
    ms = median_time(lambda: tmmcalc.solve_kinematics(spec)) * 1e3
    print(f"  whole stage, 24 positions    {ms:8.3f} ms  (structure, assembly intervals, extremes, error estimate)")
    return missed


def _in_time(t: Trace, speed: float = SPEED) -> list[np.ndarray]:
    """Time derivatives of everything, as a result gives them."""
    pairs = ((t.dr, t.ddr), (t.dangle, t.ddangle), (t.ds, t.dds))
    return [scaled for rate, rate2 in pairs for scaled in (rate * speed, rate2 * speed**2)]


def _solved(name: str, positions: int) -> tuple[Any, Any, Any]:
    """Mechanism, what acts on it, and its kinematics at so many positions."""
    spec = tmmcalc.load_spec(CONFIGS / f"{name}.toml", [f"mechanism.grid.positions={positions}"])
    mechanism = to_linkage(spec.linkage)
    return mechanism, to_loading(spec), tmmcalc.solve_kinematics(mechanism)


def forces() -> list[str]:
    """Reactions with friction in three pairs, whole stage: residuals, maxima over the cycle, both sides of jumps."""
    missed = []
    print("\nforces with friction, press (pins A, B, guide), whole stage")
    for n, bar in ((12, None), (360, 3.0), (36_000, 100.0)):
        given = _solved("press", n)
        ms = median_time(lambda given=given: solve_forces(*given)) * 1e3
        print(f"  {n:>7} positions           {ms:8.2f} ms  {bar_text(ms, bar) if bar else ''}")
        if bar and ms > bar:
            missed.append(f"forces at {n}")
    return missed


def higher() -> list[str]:
    """A six-bar of class IV: kinematics and reactions together, the list of its assemblies."""

    def whole() -> object:
        return solve_forces(mechanism, loading, tmmcalc.solve_kinematics(mechanism))

    mechanism, loading, _ = _solved("class-four", 3_600)
    missed = []
    print("\nsix-bar of class IV")
    rows: list[tuple[str, Callable[[], object], float]] = [
        ("3 600 positions with reactions", whole, 250.0),
        ("all assemblies at one position", lambda: list_assemblies(mechanism), 10.0),
    ]
    for name, work, bar in rows:
        ms = median_time(work) * 1e3
        print(f"  {name:<40} {ms:8.2f} ms  {bar_text(ms, bar)}")
        if ms > bar:
            missed.append(name)
    return missed


def machine() -> list[str]:
    """Reduction, steady motion, the true flywheel, a start-up."""
    given = _solved("piston-compressor", 360)
    reduction = solve_reduction(*given)
    spec = tmmcalc.load_spec(CONFIGS / "piston-compressor.toml")
    motor, gears = to_motor(spec), to_gears(spec)
    drive = driver_of(motor.motor, motor.characteristic, gears.ratio, 1.0)
    cycle, curve = reduction.cycle, drive.characteristic
    whole = Drive((Mass(6.4),), (), curve, cycle, reduction.idle)
    start = Scenario("start-up", 2.0, load=(LoadStep(0.0),))
    rows: list[tuple[str, Callable[[], object], float | None]] = [
        ("reduction with friction, 360 positions", lambda: solve_reduction(*given), None),
        ("steady motion under the Kloss curve", lambda: driven(cycle, 6.4, curve), 10.0),
        ("steady motion, motor lag 5 ms", lambda: driven(cycle, 6.4, curve, time_constant=5e-3), 80.0),
        ("true flywheel under the Kloss curve", lambda: required_inertia(cycle, curve, 0.0125, 0.4), 20.0),
        ("idle start-up, 2 s, Merson", lambda: simulate(whole, start), None),
    ]
    missed = []
    print("\nmachine, piston compressor")
    for name, work, bar in rows:
        ms = median_time(work) * 1e3
        print(f"  {name:<40} {ms:8.2f} ms  {bar_text(ms, bar) if bar else ''}")
        if bar and ms > bar:
            missed.append(name)
    return missed


def project() -> list[str]:
    """All stages of a project in one process; the reading of the spec apart."""
    missed = []
    print("\nwhole projects, all stages in one process")
    for name in ("press", "shaper", "piston-compressor"):
        spec = tmmcalc.load_spec(CONFIGS / f"{name}.toml")
        ms = median_time(lambda spec=spec: tmmcalc.run(spec)) * 1e3
        print(f"  {name:<28} {ms:8.1f} ms  {bar_text(ms, 300.0)}")
        if ms > 300.0:
            missed.append(f"project {name}")
    return missed


def growth() -> None:
    """Time against the number of positions and of dyads: both must be linear."""
    chain = _shaper()
    sizes = np.array([4_000, 16_000, 64_000, 256_000])
    times = [median_time(lambda n=n: trace(chain, np.linspace(0.0, 6.2, n))) for n in sizes]
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
            spent.append(median_time(lambda c=long_chain, x=x: trace(c, x)) * 1e3)
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
        "from tmmcalc.linkage.tables.tasks.mechanism import to_linkage\n"
        "m = to_linkage(tmmcalc.load_spec({file!r}).linkage)\n"
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
