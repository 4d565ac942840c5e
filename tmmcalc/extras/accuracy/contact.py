"""Methods for the elastic contact: grids ever finer beside Hertz's closed form.

Pyramids of pressure stand for a smooth one, whose slope has no bound at the border of the contact; where the border
falls between the nodes decides about the last digits, so that errors fall unevenly with the step.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.extras.contact import ContactTask, solve_contact
from tmmcalc.extras.hertz import hertz

CELLS = (8, 12, 16, 24, 32)  # steps from the middle to a corner
CLOSED = 1e-14  # of the elliptic integrals
UNEVEN = "where the border of the contact falls between the nodes makes it uneven"

Found = tuple[float, float]  # largest pressure [Pa], approach [m]


def studies(scene: Scene) -> Iterator[Study]:
    """Largest pressure and approach of two paraboloids; other gaps have no closed form."""
    task: ContactTask = scene.inputs
    if task.radii is None:
        return
    closed = partial(_closed, task.load, task.modulus, task.radii)
    exact = closed()

    def error(found: Found) -> float:
        return max(relative(a, b) for a, b in zip(found, exact, strict=True))

    ways = [Way(f"{n} cells", 1 / n, partial(_gridded, task, n)) for n in CELLS]
    yield Study(
        "contact",
        "largest pressure, approach",
        Reference("Hertz's closed form", CLOSED),
        (
            series("Hertz", [Way("", None, closed)], error, scene.clock, note="of paraboloids alone"),
            series("boundary integrals on a grid", ways, error, scene.clock, note=UNEVEN, stepwise=False),
        ),
    )


def _closed(load: float, modulus: float, radii: tuple[float, float]) -> Found:
    found = hertz(load, modulus, radii)
    return found.peak, found.approach


def _gridded(task: ContactTask, cells: int) -> Found:
    found = solve_contact(replace(task, cells=cells))
    return found.peak, found.approach
