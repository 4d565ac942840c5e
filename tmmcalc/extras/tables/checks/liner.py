"""``[liner]``: something loads it, the moment is given once, the wall and the ring have their places."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

_LOADS = ("load", "moment", "clamp", "pressure")
_SHORTEST = 0.05  # L/sqrt(r1 h): a shorter shell turns as a ring does


def check_liner(outline: Outline) -> Iterator[Finding]:
    """Loads, the ring outside the shell, a wall that leaves a bore, a length that is one of a shell."""
    if not isinstance(outline.document.get("liner"), dict):
        return
    table = subtable(outline.document, "liner")
    path: Path = ("liner",)
    if "moment" in table and "clamp" in table:
        yield Finding((*path, "moment"), "moment together with clamp: it gives the moment", "remove one of them")
    elif not any(key in table for key in _LOADS):
        rule = "missing key: nothing loads the liner"
        yield Finding(path, rule, 'add moment = "4 kN", [liner.clamp], load = "200 N/mm" or pressure = "6 MPa"')
    radius, outer, wall, length = (
        amount(table.get(key), "length") for key in ("radius", "ring_outer", "thickness", "length")
    )
    if radius is None or radius <= 0:
        return
    if outer is not None and 0 < outer <= radius:
        rule = f"the ring ends at {outer:g} m, within the shell of {radius:g} m"
        yield Finding((*path, "ring_outer"), rule, "write an outer radius above radius")
    if wall is not None and wall >= 2 * radius:
        rule = f"a wall of {wall:g} m about a mean radius of {radius:g} m leaves no bore"
        yield Finding((*path, "thickness"), rule, f"write a wall below {2 * radius:g} m; a thin one is a tenth of r1")
    elif wall is not None and wall > 0 and length is not None and 0 < length < _SHORTEST * (radius * wall) ** 0.5:
        rule = f"a shell of {length:g} m is too short to bend"
        least = _SHORTEST * (radius * wall) ** 0.5
        yield Finding((*path, "length"), rule, f"write {least:.3g} m at least, or leave it out for a long one")


CHECKS = (check_liner,)
