"""Headers of columns: a name, and its unit in brackets."""

import re

_INDEX = re.compile(r"-?\d+")


def key_and_unit(header: str) -> tuple[str, str]:
    """The key and the unit of a header: what a last bracket holds, if that is no index and no choice.

    >>> key_and_unit("R_A[N]"), key_and_unit("links[id=1].points.A[0][mm]"), key_and_unit("points.A[0]")
    (('R_A', 'N'), ('links[id=1].points.A[0]', 'mm'), ('points.A[0]', ''))
    """
    key, _, last = header.removesuffix("]").rpartition("[")
    is_unit = header.endswith("]") and key and last and not any(sign in last for sign in "]=\"'")
    return (key, last) if is_unit and not _INDEX.fullmatch(last) else (header, "")
