"""Torque diagrams without a mechanism: a formula, harmonics, straight pieces or a table become a `Cycle`.

Beside them a table of the reduced inertia does.

``theta`` [rad] is the angle of the shaft from the beginning of the diagram; the moment [N*m] is positive where it
drives. Several engines or cylinders on one shaft are superposed with their delays; ``balanced`` loads a diagram with
the constant moment that closes its work.
"""

from tmmcalc.machine.diagram.sources import from_formula, from_harmonics, from_inertia, from_pieces, from_table
from tmmcalc.machine.diagram.superposition import balanced, combined, even_delays, superposed

__all__ = [
    "balanced",
    "combined",
    "even_delays",
    "from_formula",
    "from_harmonics",
    "from_inertia",
    "from_pieces",
    "from_table",
    "superposed",
]
