"""Function generation: the rocker's angle psi, or the slider's place s, as a wanted function of the crank's angle phi.

The closure of the linkage is linear in three combinations of its sizes (Freudenstein):

    four-bar       K1 cos(psi) - K2 cos(phi) + K3 = cos(phi - psi)      K1 = d/a, K2 = d/c, 2 a c K3 = a2 + c2 + d2 - b2
    slider-crank   K1 s cos(phi) + K2 sin(phi) - K3 = s^2               K1 = 2 r, K2 = 2 r e, K3 = r2 - l2 + e2

with D to the right of A, and a guide along x at the height e. Where x begins, phi and psi (or s) have free offsets, so
that three points are met with given offsets, four with one free, five with both; more points in the least squares.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.plane import Real
from tmmcalc.core.progress import tell
from tmmcalc.linkage.synthesis.freudenstein import closure_of, exact_points, solved_exactly
from tmmcalc.linkage.synthesis.functiondesign import design_of, structural_error
from tmmcalc.linkage.synthesis.functionfit import Fitted, best_fits, rated
from tmmcalc.linkage.synthesis.results import Design, SearchStep, Synthesis
from tmmcalc.linkage.synthesis.task import FunctionTask, SynthesisTask

RULE = "fewest defects; then the least structural error over the range"
GRID = 72  # values of a free offset that are tried
KEPT = 400  # candidates that are compared
LOOKED = 40  # that are simulated, at most


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages that generate the function; raises `NoSolutionError` if none assembles at all points."""
    asked: FunctionTask = task.asked
    closure = closure_of(asked)
    exact = is_exact(asked)
    tell(0.0, "precision points")
    course: list[SearchStep] = []
    found = solved_exactly(closure, GRID) if exact else best_fits(closure, GRID, course)
    if not len(found.offsets):
        raise _none(asked)
    fitted = rated(closure, found, task.transmission, exact)
    designs = [design for k in _best(fitted) if (design := design_of(task, closure, fitted, k)) is not None]
    designs = sorted(
        designs, key=lambda design: (len(design.defects), design.merits[structural_error(closure).marked("max").key])
    )
    if not designs:
        raise _none(asked)
    shown = tuple(designs[: task.solutions])
    residual = _residual(shown) if exact else 0.0
    counters = {"candidates": len(found.offsets), "designs": len(designs)}
    return Synthesis("function", RULE, shown, residual, tuple(_notes(asked, exact, shown)), counters, tuple(course))


def is_exact(asked: FunctionTask) -> bool:
    """Whether the points are no more than a linkage of this kind can meet exactly."""
    return len(asked.inputs) <= exact_points(closure_of(asked))


def _best(fitted: Fitted) -> list[int]:
    """Candidates by defects and error, near copies of a better one left out."""
    order = np.lexsort((fitted.error, fitted.defects))
    kept: list[int] = []
    for k in order[:KEPT].tolist():
        sizes = fitted.sizes[k]
        if all(np.max(np.abs(sizes - fitted.sizes[j])) > 0.02 * np.max(np.abs(sizes)) for j in kept):
            kept.append(k)
        if len(kept) == LOOKED:
            break
    return kept


def _residual(designs: tuple[Design, ...]) -> float:
    found = [design.precision for design in designs if not any(words.startswith("branch") for words in design.defects)]
    return max((float(np.max(np.abs(each.found - each.wanted))) for each in found if each is not None), default=0.0)


def _notes(asked: FunctionTask, exact: bool, designs: tuple[Design, ...]) -> Iterator[str]:
    count = len(asked.inputs)
    if exact:
        yield Phrase("note: the {count} precision points are met exactly", count=count)
    else:
        yield Phrase(
            "note: {count} points are more than can be met exactly: they are met in the least squares", count=count
        )
    if designs[0].defects:
        yield Phrase("warning: the best design has a defect: {defects}", defects=listed(designs[0].defects, "; "))


def _none(asked: FunctionTask) -> NoSolutionError:
    return NoSolutionError(
        f"no {asked.mechanism.replace('_', '-')} was found that assembles at all {len(asked.inputs)} points",
        where="synthesis.function",
        value=float(len(asked.inputs)),
        remedy="leave input_start and output_start free, take fewer points, or a smaller range of the crank or output",
    )


def chebyshev(count: int, low: float, high: float) -> Real:
    """Precision points (count,) of Chebyshev's spacing in (low, high), ascending.

    >>> [round(float(x), 6) for x in chebyshev(3, 0.0, 1.0)]
    [0.066987, 0.5, 0.933013]
    """
    k = np.arange(1, count + 1)
    return (low + high) / 2 - (high - low) / 2 * np.cos((2 * k - 1) * math.pi / (2 * count))
