"""A mechanism as the text of a spec that the other commands run: every number with all its digits."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.model import Assembly, Grid, Joint, Link, Mechanism, Output
from tmmcalc.linkage.synthesis.strokes import TURN

FULL = 1e-12  # a span this near to a turn is one


def ready_spec(mechanism: Mechanism, title: str, remarks: tuple[str, ...] = (), loads: tuple[Load, ...] = ()) -> str:
    """The TOML text; ``remarks`` stand in comments at its head, constant ``loads`` at its end."""
    head = [f"# {line}" for line in (title, *remarks)]
    blocks = [[*head], ["[project]", f"title = {_text(title)}"], *_blocks(mechanism)]
    blocks += [["[[loads]]", *_load(load)] for load in loads]
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _blocks(mechanism: Mechanism) -> Iterator[list[str]]:
    drive = mechanism.input
    yield ["[mechanism.grid]", *_grid(mechanism.grid)]
    start = '"extreme"' if drive.start is None else _angle(drive.start)
    speed = f'"{drive.speed!r} rad/s"'
    yield ["[mechanism.input]", f"joint = {_text(drive.joint)}", f"speed = {speed}", f"start = {start}"]
    for output in mechanism.outputs:
        yield ["[[mechanism.outputs]]", *_output(output)]
    yield ["[mechanism.fixed]", *(f"{name} = {_point(at)}" for name, at in mechanism.frame.points.items())]
    for link in mechanism.links:
        points = ", ".join(f"{name} = {_point(at)}" for name, at in link.points.items())
        yield ["[[mechanism.links]]", f"id = {link.id}", f"name = {_text(link.name)}", f"points = {{ {points} }}"]
    for joint in mechanism.joints:
        yield ["[[mechanism.joints]]", *_joint(mechanism, joint)]
    yield ["[mechanism.assembly]", *_assembly(mechanism.assembly)]


def _assembly(assembly: Assembly) -> Iterator[str]:
    if assembly.at is not None:
        yield f"at = {_angle(assembly.at)}"
    if assembly.sketch:
        places = ", ".join(f"{name} = {_point(at)}" for name, at in assembly.sketch.items())
        yield f"sketch = {{ {places} }}"
    if assembly.variants:
        signs = ", ".join(f'"{"-".join(map(str, links))}" = {sign}' for links, sign in assembly.variants.items())
        yield f"variants = {{ {signs} }}"


def _load(load: Load) -> Iterator[str]:
    """A constant load; raises `UsageError` for another law."""
    if not isinstance(load.law, Constant):
        raise UsageError("only constant loads stand in a ready spec", where="ready spec", remedy="write it by hand")
    yield f"name = {_text(load.name)}"
    yield f"link = {load.link}"
    if load.kind == "force":
        yield f"point = {_point(load.point)}"
        yield f"direction = {_angle(phase(load.direction))}"
        yield f"axes = {load.follows}"
    unit = "N" if load.kind == "force" else "N*m"
    yield f'{load.kind} = "{load.law.value!r} {unit}"'


def _grid(grid: Grid) -> Iterator[str]:
    yield f"positions = {grid.positions}"
    if grid.span is not None and abs(grid.span - TURN) > FULL:
        yield f"span = {_angle(grid.span)}"
    if grid.extra:
        yield f"extra = [{', '.join(_angle(along) for along in grid.extra)}]"
    if grid.extremes:
        yield "extremes = true"


def _output(output: Output) -> Iterator[str]:
    if output.label is not None:
        yield f"name = {_text(output.label)}"
    if output.point is not None:
        yield f"point = {_text(output.point)}"
        yield f"direction = {_angle(output.direction)}"
    elif output.link is not None:
        yield f"link = {output.link}"
    else:
        yield f"joint = {_text(output.joint or '')}"
    if output.resistance is not None:
        yield f"resistance = {_text(output.resistance)}"


def _joint(mechanism: Mechanism, joint: Joint) -> Iterator[str]:
    yield f"name = {_text(joint.name)}"
    yield f"kind = {_text(joint.kind)}"
    yield f"links = [{joint.links[0]}, {joint.links[1]}]"
    if joint.kind == "prismatic":
        slider, guide = (mechanism.link(link) for link in joint.links)
        yield f"guide = {{ through = {_named(guide, joint.points[1])}, angle = {_angle(phase(joint.directions[1]))} }}"
        if joint.points[0]:
            yield f"slider = {{ through = {_named(slider, joint.points[0])} }}"


def _named(link: Link, at: complex) -> str:
    """A point of a link by its name if it has one, else by its coordinates."""
    name = next((name for name, place in link.points.items() if place == at), None)
    return _point(at) if name is None else _text(name)


def _point(at: complex) -> str:
    return f"[{_length(at.real)}, {_length(at.imag)}]"


def _length(value: float) -> str:
    return f'"{value!r} m"' if value else "0"


def _angle(value: float) -> str:
    return f'"{value!r} rad"' if value else "0"


def _text(text: str) -> str:
    """A TOML string of one line."""
    from json import dumps

    return dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
