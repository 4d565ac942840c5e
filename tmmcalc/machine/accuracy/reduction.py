"""Methods of integration over the cycle: trapezoid and Simpson on equal steps, Gauss on panels that end at every jump.

The quantity is the work that all moments turn over in a cycle, by contribution; the time includes the moments at the
nodes, which is where it goes. The trapezoid rule converges faster than any power of the step while the moments are
smooth and periodic, and falls back to second order at a kink, to first at a jump.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.core.plane import Real
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.machine.accuracy import inertia
from tmmcalc.machine.model import TorqueTask
from tmmcalc.machine.reduction.causes import Causes, causes_of
from tmmcalc.machine.reduction.inertia import lumped, rods_of
from tmmcalc.machine.reduction.results import Reduction

Rule = Callable[[Real, Real], float | None]  # nodes and values (n + 1,) -> integral; n is even, so none is None

SPECTRAL = "beyond every order where the moments are smooth and periodic; of order 2 at a kink, 1 at a jump"
FOURTH = "of order 4 where the moments are smooth; of order 2 at a kink, 1 at a jump"
COUNTS = (6, 12, 24, 48, 72, 96, 192, 384, 768, 1536)
SIMPSON_ORDER = 4.0


def studies(scene: Scene) -> Iterator[Study]:
    """Work per cycle, reduced inertia and its derivative; nothing for a diagram that is given by points."""
    if isinstance(scene.inputs, TorqueTask):
        return
    yield from _works(scene)
    mechanism, loading, _ = scene.inputs
    compiled = compile_scene(mechanism, loading, scene.results["kinematics"])
    yield from inertia.studies(mechanism, loading, compiled, scene.clock)


def _works(scene: Scene) -> Iterator[Study]:
    """The work of every contribution over the cycle by every rule."""
    causes, powers = _causes(scene)
    result: Reduction = scene.results["reduction"]
    panels = result.cycle.panels

    def works(theta: Real, rule: Callable[[Real], Real]) -> Real:
        return rule(causes.along(theta).moments * powers[:, None])

    def on(which: Panels) -> Real:
        shape = which.x.shape
        return works(which.x.ravel(), lambda moments: which.total(moments.reshape(len(moments), *shape)))

    finer = panels.halved()
    exact = on(finer)
    turned = float(np.sum(panels.total(np.abs(result.parts))))  # what the works are measured against
    if not turned:
        return  # nothing but inertia: no work to integrate

    def error(found: Real) -> float:
        return relative(found, exact, turned)

    own = error(on(panels))
    period = result.cycle.period

    def equal(n: int, rule: Rule) -> Callable[[], Real]:
        theta = np.linspace(0.0, period, n + 1)
        return lambda: works(theta, lambda moments: np.array([rule(theta, row) for row in moments]))

    yield Study(
        "reduction",
        "work per cycle",
        Reference(f"Gauss on {finer.count} panels of {finer.order} points, each half of a panel of the stage", own),
        (
            series("Gauss on panels", [Way(f"{panels.count} panels", None, lambda: on(panels))], error, scene.clock),
            series("trapezoid", _ways(equal, _trapezoid), error, scene.clock, note=SPECTRAL),
            series("Simpson", _ways(equal, simpson), error, scene.clock, expected=SIMPSON_ORDER, note=FOURTH),
        ),
    )


def _ways(equal: Callable[[int, Rule], Callable[[], Real]], rule: Rule) -> list[Way]:
    return [Way(f"{n} steps", 1.0 / n, equal(n, rule)) for n in COUNTS]


def _trapezoid(x: Real, y: Real) -> float:
    return float(np.trapezoid(y, x))


def _causes(scene: Scene) -> tuple[Causes, Real]:
    """What is reduced, and the powers of the mean speed of every contribution."""
    mechanism, loading, rods = scene.inputs
    if rods == "lumped":
        from dataclasses import replace

        loading = replace(loading, bodies=lumped(mechanism, loading, rods_of(mechanism, loading)))
    compiled = compile_scene(mechanism, loading, scene.results["kinematics"])
    causes = causes_of(compiled)
    return causes, np.asarray(abs(compiled.travel.speed) ** causes.orders)
