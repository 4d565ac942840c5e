"""The table ``[manipulator]`` as it is written, for its checks."""

from __future__ import annotations

from tmmcalc.spec.outline import Outline, Raw, subtable

ROOT = "manipulator"
ARM_JOINTS = {"spherical": ("phi_2", "l_3"), "cylindrical": ("h", "r"), "angular": ("phi_2", "phi_3")}
_LENGTHS = ("l_3", "h", "r")
_OF_PATH = ("speed", "acceleration", "normal_acceleration", "total_acceleration", "duration")
_KEYS = {
    "arc": ("start", "end", "radius", "side", "via", "normal"),
    "line": ("start", "end"),
    "polyline": ("points", "corner_radius"),
}


def written_manipulator(outline: Outline) -> Raw:
    """The table, empty if it is none."""
    return subtable(outline.document, ROOT)


def turns_base(table: Raw) -> bool:
    """Whether the base turns: the first point has three coordinates, or psi is among the joints."""
    path = subtable(table, "path")
    listed = path.get("points")
    first = path.get("start", listed[0] if isinstance(listed, list) and listed else None)
    if isinstance(first, list):
        return len(first) == 3
    return any("psi" in subtable(table, key) for key in ("joints", "motion"))
