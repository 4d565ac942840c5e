"""Memory of temporaries: kept between array operations instead of fetched anew for each.

The C library of Linux gives a large block back to the system as soon as it is freed, and the next operation pays for
fresh pages: at 36 000 positions a fifth of the time of a force analysis. What counts as large adapts: the limit grows
to the size of a block that has been given back (up to 32 MB). So one block, larger than all temporaries to come,
asked for and freed, makes their pages stay. Other libraries have their own rules, and there it does nothing.
"""

from __future__ import annotations

from functools import cache

import numpy as np

LARGEST = 1 << 24  # bytes of a temporary whose pages are kept: 16 MB


@cache
def keep_pages() -> None:
    """Let freed temporaries keep their pages; once a process, a few microseconds."""
    np.empty(LARGEST, np.uint8)
