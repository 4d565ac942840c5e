"""Whether vibration parts the follower from the cam, or in a groove sends the roller from wall to wall.

The load is the force along the lift of all that acts on the follower but the cam: negative, it presses on the cam or on
the inner wall.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from tmmcalc.cams.follower import Closure
from tmmcalc.cams.forces.turn import crossings, spans
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

LEVEL = 1e-9  # of the largest load: what counts as none
Spans = tuple[tuple[float, float], ...]


@record
class Contact:
    """The contact over the turn, of an elastic train and of a rigid one."""

    closure: Closure
    judged: bool = quantity("judged", "the forces that press are known, or walls hold the roller")
    largest: float = quantity(
        "P_c_max[{force}]", "largest load along the lift; positive where the cam does not hold the follower"
    )
    beyond: Spans  # from phi to phi [rad]: it leaves the cam, in a groove the outer wall presses
    rigid: Spans  # the same of a rigid train

    @derived("lost[rad]", "angles of the cam between which the follower leaves it")
    def lost(self) -> Spans:
        """Of a follower that a force closes."""
        return self.beyond if self.judged and self.closure == "force" else ()

    @derived("reversals[rad]", "angles of the cam at which the roller goes to the other wall of a groove")
    def reversals(self) -> tuple[float, ...]:
        """Ends of the intervals in which the outer wall presses."""
        return _ends(self.beyond) if self.closure == "groove" else ()


def contact_of(task: CamTask, loads: Loads, on: Panels, load: Values, rigid: Values) -> Contact:
    """The contact under the loads (K, N)."""
    force = loads.force
    acts = loads.mass or loads.spring.method != "none" or force.rise or force.back or force.values is not None
    closure = task.asked.closure
    largest = on.extremes(load)[1][0]
    return Contact(closure, closure == "groove" or bool(acts), largest, _lifted(on, load), _lifted(on, rigid))


def _lifted(on: Panels, load: Values) -> Spans:
    """Where a load is positive, beyond rounding."""
    if np.max(load) <= 0:
        return ()
    edges = np.sort(np.concatenate((on.edges, crossings(on, load))))
    middle = (edges[:-1] + edges[1:]) / 2
    return spans(edges, on.at(load, middle) > LEVEL * np.max(np.abs(load)))


def _ends(beyond: Spans) -> tuple[float, ...]:
    """Where the intervals begin and end; the begin of the turn is no end if one goes on over it."""
    ends = [phi for span in beyond for phi in span]
    goes_on = len(ends) > 1 and ends[0] == 0 and ends[-1] >= 2 * np.pi * (1 - 1e-12)
    return tuple(ends[1:-1] if goes_on else ends)


def contact_notes(contact: Contact) -> Iterator[str]:
    """What vibration does to the contact."""
    if contact.lost:
        where = [Phrase("{low:.5g} to {high:.5g} deg", low=degrees(a), high=degrees(b)) for a, b in contact.lost]
        text = "warning: the follower leaves the cam for phi from {where}, which a rigid one would not"
        if contact.rigid:
            text = "warning: the follower leaves the cam for phi from {where}, as a rigid one does"
        yield Phrase(text, where=where)
    if contact.reversals:
        yield (
            Phrase(
                "note: the roller goes to the other wall of the groove {reversals} times a turn, with an impact "
                "if it has play there; on a rigid train {ends} times",
                reversals=len(contact.reversals),
                ends=len(_ends(contact.rigid)),
            )
        )
    if not contact.judged:
        yield "note: contact is not judged: nothing is known of what presses the follower on the cam; add [cam.loads]"
