"""Pages of the ready specs, and what the stages find there."""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import tmmcalc
from tmmcalc.cli import main
from tmmcalc.linkage.tables.tasks.placed import with_position, with_positions
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

CONFIGS = Path(__file__).parents[2] / "configs"
SPECS = [file.stem for file in sorted(CONFIGS.glob("*.toml"))]
MOVING = [  # those in which a linkage moves
    name for name in SPECS if "mechanism" in tomllib.loads((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))
]

Real = NDArray[np.float64]


def write(spec: Path, file: Path, *options: str) -> None:
    """The page of a spec, as ``tmmcalc page`` writes it."""
    command("page", str(spec), "-o", str(file), "--no-store", "--quiet", *options)


def command(*argv: str) -> None:
    """A command, in this process."""
    kept, sys.argv = sys.argv, ["tmmcalc", *argv]
    try:
        with pytest.raises(SystemExit) as ended:
            main()
    finally:
        sys.argv = kept
    assert not ended.value.code


def solved(name: str, stage: str, changed: Sequence[str] = (), positions: int | None = 360) -> dict[str, Real]:
    """The columns of a stage over so many equal steps, or over the positions of the spec."""
    spec: Any = load_spec(CONFIGS / f"{name}.toml", changed)
    if positions is not None:
        spec = with_positions(spec, positions)
    return tmmcalc.columns(run(spec, target=[stage]), stage)


def places(name: str, inputs: Iterable[float], changed: Sequence[str] = ()) -> list[dict[str, complex]]:
    """Where the kinematics finds the named points at these inputs [m]."""
    spec: Any = load_spec(CONFIGS / f"{name}.toml", changed)
    asked = list(inputs)
    for at in asked:
        spec = with_position(spec, repr(at))
    found = tmmcalc.columns(run(spec, target=["kinematics"]), "kinematics")
    along = found[next(header for header in found if header.startswith("phi["))]
    names = [header[2:-3] for header in found if header.startswith("x_") and header.endswith("[m]")]
    rows = [int(np.argmin(np.abs(along - at))) for at in asked]
    assert np.allclose(along[rows], asked, rtol=0, atol=1e-6 * np.ptp(along))
    return [{n: complex(found[f"x_{n}[m]"][row], found[f"y_{n}[m]"][row]) for n in names} for row in rows]


class Fit:
    """The scale and the place of a drawing, from where points are and where they are seen, and how far these differ."""

    def __init__(self, true: Collection[complex], seen: Collection[complex]) -> None:
        z, w = np.array([*true]), np.array([*seen])
        dz, dw = z - z.mean(), w - w.mean()
        self.scale = float(np.sum(dw * dz.conj()).real / np.sum(np.abs(dz) ** 2))
        self.origin = complex(w.mean() - self.scale * z.mean())
        self.size = float(max(np.ptp(w.real), np.ptp(w.imag)))
        self.error = float(np.abs(w - self.scale * z - self.origin).max())
