"""The ratio of the speeds of motor and crank, and the rounds in which a motor to choose and its train settle."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.machine.settled import Settled
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph
from tmmcalc.report.telling import tabulated


def blocks(order: Order) -> Iterator[Block]:
    """The rounds; where the motor is given, its ratio is told with the motor."""
    result: Settled = order.results["drive"]
    rounds = result.rounds
    if not rounds:
        return
    yield Heading(tr("Ratio of the drive"))
    yield Paragraph(
        tr(
            "The ratio depends on the speed of the motor, the required power of the motor on the efficiency of the "
            "gears. Both are settled in rounds (table {tab:drive_rounds}): the motor with the gears of the round "
            "before, the gears with the ratio of this motor, until the motor comes again."
        )
    )
    columns = {
        "$u$": [each.ratio for each in rounds],
        "$eta_u$": [each.efficiency for each in rounds],
        "$J_g$, kg*m^2": [each.inertia for each in rounds],
    }
    labels = [f"{each.motor}, {each.train}" if each.train else each.motor for each in rounds]
    yield tabulated(tr("Rounds of the choice"), columns, labels, head=tr("Motor, train"), key="drive_rounds")
