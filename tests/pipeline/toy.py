"""A toy pipeline: geometry -> path -> energy, with `spare` that nobody needs.

Its stages note each call in `CALLS`, so a test can see what was imported from files and what was computed.
"""

from __future__ import annotations

import pathlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tmmcalc.core.errors import AssemblyError
from tmmcalc.core.stage import Stage
from tmmcalc.core.stored import Record, Table
from tmmcalc.pipeline.runner import RunResult, run

CALLS: list[str] = []


@dataclass(frozen=True)
class Spec:
    title: str = "toy"
    radius: float = 0.2
    positions: int = 25
    speed: float | None = 5.76
    points: dict[str, complex] = field(default_factory=lambda: {"A": 0.1 + 0j, "B": 1 / 3 + 2j / 7})
    broken: bool = False


@dataclass(frozen=True)
class Circle:
    radius: float
    points: dict[str, complex]


@dataclass(frozen=True)
class Path2D:
    phi: np.ndarray
    xy: np.ndarray  # (n, points, 2), Fortran order on purpose
    method: str


@dataclass(frozen=True)
class Energy:
    total: float
    by_position: np.ndarray


class Geometry:
    @staticmethod
    def inputs(spec: Spec) -> Circle:
        return Circle(spec.radius, spec.points)

    @staticmethod
    def solve(circle: Circle) -> Circle:
        CALLS.append("geometry")
        return circle

    @staticmethod
    def dump(circle: Circle) -> Record:
        points = {name: (z.real, z.imag) for name, z in circle.points.items()}
        return Record({"radius": np.float64(circle.radius), "points": points}, counters={"points": len(points)})

    @staticmethod
    def load(record: Record) -> Circle:
        points = {name: complex(*pair) for name, pair in record.scalars["points"].items()}
        return Circle(record.scalars["radius"], points)


class Path:
    @staticmethod
    def inputs(spec: Spec) -> tuple[int, bool]:
        return (spec.positions, spec.broken)

    @staticmethod
    def solve(positions: int, broken: bool, *, geometry: Circle, method: str) -> Path2D:
        CALLS.append("path")
        if broken:
            raise AssemblyError("the links do not reach", where="path")
        phi = np.linspace(0, 2 * np.pi, positions)
        turned = [z * geometry.radius * np.exp(1j * phi) for z in geometry.points.values()]
        xy = np.stack([np.stack([z.real for z in turned]), np.stack([z.imag for z in turned])]).T
        return Path2D(phi, xy, method)

    @staticmethod
    def dump(path: Path2D) -> Record:
        return Record({"method": path.method}, {"phi": path.phi, "xy": path.xy}, {"position": 1e-16})

    @staticmethod
    def load(record: Record) -> Path2D:
        return Path2D(record.arrays["phi"], record.arrays["xy"], record.scalars["method"])

    @staticmethod
    def table(path: Path2D) -> Table:
        columns = [np.degrees(path.phi), *path.xy.reshape(len(path.phi), -1).T]
        names = [f"{axis}_{at // 2}[m]" for at, axis in enumerate("xy" * (len(columns) // 2))]
        return Table(["phi[deg]", *names], columns)


def energy_wanted(spec: Spec) -> str | None:
    return None if spec.speed is not None else "no [motor]: speed is constant"


class OfEnergy:
    @staticmethod
    def inputs(spec: Spec) -> float:
        assert spec.speed is not None
        return spec.speed

    @staticmethod
    def solve(speed: float, path: Path2D) -> Energy:
        CALLS.append("energy")
        square = (path.xy * speed) ** 2
        return Energy(float(square.sum(axis=0).sum()), square.sum(axis=(1, 2)))

    @staticmethod
    def dump(energy: Energy) -> Record:
        return Record({"total": energy.total}, {"by_position": energy.by_position})

    @staticmethod
    def load(record: Record) -> Energy:
        return Energy(record.scalars["total"], record.arrays["by_position"])


def stage(name: str, home: str, **more: Any) -> Stage:
    return Stage(name=name, title=f"the {name}", home=f"{__name__}:{home}", **more)


STAGES: dict[str, Stage] = {
    "geometry": stage("geometry", "Geometry"),
    "path": stage("path", "Path", needs=("geometry",), settings={"method": "closed"}),
    "energy": stage("energy", "OfEnergy", needs=("path",), wanted=f"{__name__}:energy_wanted"),
    "spare": Stage("spare", "never imported", "no_such_module", needs=("energy",)),
}
TOY = {name: STAGES[name] for name in ("geometry", "path", "energy")}


def go(spec: Spec = Spec(), out: pathlib.Path | None = None, **more: Any) -> RunResult:
    """Run the toy pipeline, with `CALLS` cleared before."""
    CALLS.clear()
    return run(spec, out=out, stages=more.pop("stages", TOY), **more)


def shown(result: RunResult) -> list[tuple[str, str]]:
    """Stage and kind of every event."""
    return [(event.stage, event.kind) for event in result.events]


def contents(folder: Path) -> dict[str, bytes]:
    """Every file that a run leaves, but not the log, which holds times."""
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir()) if path.name != "run.log"}
