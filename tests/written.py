"""Links and joints of a linkage as they are written in a spec."""

from __future__ import annotations


def link(number: int, points: str, *keys: str) -> str:
    """A link with its points, ``A = [0, 0], B = [1, 0]``, and further keys, a line each."""
    lines = ("[[mechanism.links]]", f"id = {number}", f"points = {{ {points} }}", *keys)
    return "".join(f"{line}\n" for line in lines)


def pin(name: str, one: int, other: int) -> str:
    """A revolute joint."""
    return f'[[mechanism.joints]]\nname = "{name}"\nkind = "revolute"\nlinks = [{one}, {other}]\n'


def slide(name: str, one: int, other: int, guide: str, *keys: str) -> str:
    """A prismatic joint with its guide on the second link, ``through = "O"``, and further keys, a line each."""
    lines = ("[[mechanism.joints]]", f'name = "{name}"', 'kind = "prismatic"', f"links = [{one}, {other}]")
    return "".join(f"{line}\n" for line in (*lines, f"guide = {{ {guide} }}", *keys))


PINS = pin("O", 0, 1) + pin("A", 1, 2) + pin("B", 2, 3)  # of a chain of three links from the frame
