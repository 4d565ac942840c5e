"""The laws of loads that depend on the position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.loadlaws.law import Law

if TYPE_CHECKING:
    from tmmcalc.linkage.loads.values import Acting, Value


class Placed(Law):
    """A law of the position; such a load may have a window."""

    def along(self, acting: Acting) -> Value:
        """The value of a load along the motion, and where it is not smooth."""
        raise NotImplementedError
