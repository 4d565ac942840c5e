"""The rules by which the shifts x1, x2 of a pair are chosen.

given                 x1 and x2 as they are           max_contact_strength  the largest x1 + x2 (point C)
given_aw              a centre distance               equal_sliding         theta1 = theta2 at a contact ratio (D)
zero                  x1 = x2 = 0                     max_contact_ratio     the largest eps_alpha (E)
equal_shift           x1 = -x2                        equal_strength        the largest x1 + x2 with Y_F1 = Y_F2
balanced              farthest from every limit
"""

from __future__ import annotations

from typing import Literal, get_args

Strategy = Literal[
    "given",
    "given_aw",
    "max_contact_strength",
    "equal_sliding",
    "max_contact_ratio",
    "zero",
    "equal_shift",
    "equal_strength",
    "balanced",
]
Split = Literal["equal_sliding", "equal_strength", "max_contact_ratio", "middle"]  # of a sum x1 + x2 between the two
STRATEGIES: tuple[str, ...] = get_args(Strategy)
DESIRED = 1.2  # contact ratio of point D
