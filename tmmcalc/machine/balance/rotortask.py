"""Balance of a rotor as a project asks for it."""

from __future__ import annotations

from tmmcalc.core.records import record
from tmmcalc.machine.balance.rotors import RotorBalance, RotorVerdict, rotor_balance, verdict
from tmmcalc.machine.balance.weights import Weight, sized
from tmmcalc.machine.model import RotorTask


@record
class BalancedRotor:
    """A rotor before and after balancing, its correction masses, and whether it kept its grade before and after."""

    balance: RotorBalance
    static: Weight | None  # correction in one plane at the chosen radius; None without a radius
    dynamic: tuple[Weight, ...]  # corrections in two planes
    grade: tuple[RotorVerdict, ...]  # before, after static, after two-plane balancing; empty without a grade


def solve_rotor(task: RotorTask) -> BalancedRotor:
    """Static and two-plane balancing of a rotor."""
    balance = rotor_balance(task.rotor, task.planes, task.static_plane)
    states = (balance.before, balance.static, balance.dynamic)
    return BalancedRotor(
        balance,
        sized(balance.static_moment, radius=task.radius) if task.radius is not None else None,
        tuple(sized(moment, radius=task.radius) for moment in balance.moments) if task.radius is not None else (),
        tuple(verdict(task.rotor, now, task.grade) for now in states) if task.grade is not None else (),
    )
