"""The Python API of the small calculators, and whether results keep the constraints of a spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.api import solved

if TYPE_CHECKING:
    from tmmcalc.extras.bearing import Bearing, BearingTask
    from tmmcalc.extras.contact import Contact, ContactTask
    from tmmcalc.extras.falling_ball import Ball, BallTask
    from tmmcalc.extras.liner import Liner, LinerTask
    from tmmcalc.extras.reliability import Reliability, ReliabilityTask
    from tmmcalc.extras.tie_down import TieDown, TieDownTask
    from tmmcalc.extras.transloader import Transloader, TransloaderTask
    from tmmcalc.feasibility.judge import Feasibility
    from tmmcalc.project import Spec


def solve_contact(scene: Spec | ContactTask) -> Contact:
    """Pressure and approach of the two bodies of a spec or of a plain `ContactTask`, with Hertz as check.

    Raises `NoSolutionError` for a grid that is too coarse, `UsageError` for a gap without a value.
    """
    from tmmcalc.extras.contact import ContactTask
    from tmmcalc.extras.contact import solve_contact as _solve

    return _solve(scene) if isinstance(scene, ContactTask) else solved(scene, "contact")


def solve_reliability(scene: Spec | ReliabilityTask) -> Reliability:
    """Reliability and life of the product of a spec or of a plain `ReliabilityTask`.

    Raises `NoSolutionError` if no decay of the strength gives the mean life of a test.
    """
    from tmmcalc.extras.reliability import ReliabilityTask
    from tmmcalc.extras.reliability import solve_reliability as _solve

    return _solve(scene) if isinstance(scene, ReliabilityTask) else solved(scene, "reliability")


def solve_tie_down(scene: Spec | TieDownTask) -> TieDown:
    """Forces in the ties of the load of a spec or of a plain `TieDownTask`.

    Raises `NoSolutionError` for a load that leaves its cradle.
    """
    from tmmcalc.extras.tie_down import TieDownTask
    from tmmcalc.extras.tie_down import solve_tie_down as _solve

    return _solve(scene) if isinstance(scene, TieDownTask) else solved(scene, "tie_down")


def solve_falling_ball(scene: Spec | BallTask) -> Ball:
    """Speed and way of the ball of a spec or of a plain `BallTask`, its maximum and its stop."""
    from tmmcalc.extras.falling_ball import BallTask
    from tmmcalc.extras.falling_ball import solve_falling_ball as _solve

    return _solve(scene) if isinstance(scene, BallTask) else solved(scene, "falling_ball")


def solve_bearing(scene: Spec | BearingTask) -> Bearing:
    """Speeds and frequencies of the defects of the bearing of a spec or of a plain `BearingTask`."""
    from tmmcalc.extras.bearing import BearingTask
    from tmmcalc.extras.bearing import solve_bearing as _solve

    return _solve(scene) if isinstance(scene, BearingTask) else solved(scene, "bearing")


def solve_liner(scene: Spec | LinerTask) -> Liner:
    """Forces between ring and shell, deflection and stresses of the liner of a spec or of a plain `LinerTask`."""
    from tmmcalc.extras.liner import LinerTask
    from tmmcalc.extras.liner import solve_liner as _solve

    return _solve(scene) if isinstance(scene, LinerTask) else solved(scene, "liner")


def solve_transloader(scene: Spec | TransloaderTask) -> Transloader:
    """Speeds, loads by case and stresses of the transloader of a spec or of a plain `TransloaderTask`."""
    from tmmcalc.extras.transloader import TransloaderTask
    from tmmcalc.extras.transloader import solve_transloader as _solve

    return _solve(scene) if isinstance(scene, TransloaderTask) else solved(scene, "transloader")


def solve_feasibility(spec: Spec) -> Feasibility:
    """Whether the results of a spec keep its constraints; of a synthesis all designs, ``.chosen`` the best of them.

    Raises `UsageError` for a quantity that a stage does not tell, and what the stages that it asks about raise.
    """
    return solved(spec, "feasibility")
