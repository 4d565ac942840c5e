"""What is stored of a blocking contour beside its lines."""

from __future__ import annotations

from tmmcalc.core.records import record


@record
class ContourError:
    """Relative errors of a contour."""

    area: float
    corners: float  # of the shifts, to the largest of them
