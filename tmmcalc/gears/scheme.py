"""What the layout of a gear train tells of itself: wheels, meshes, what its teeth obey, how it is built and drawn.

Wheels are named as in the textbook: 1 drives, 2 and 2' turn together, 3 (or 4) is the last. The letters of a planetary
train name its meshes, A external and I internal; the bar (``AIbar``) says that one single planet makes both.
The *tooth ratio* of a train is U = Z2 Z3 / (Z1 Z2') (4.2), always positive, with its modifications:

    AIbar  U = Z3/Z1        2A-AA  U = Z4/Z1        AII  i_14 = (1 + Z3/Z1)/(1 - Z3 Z2'/(Z2 Z4)), with its sign

A layout is a file of the package ``layouts``; its ``Layout`` stands in the list there, and nowhere else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from typing import Any, Literal, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

CARRIER = "H"

Shape = Literal["pinion", "wheel", "ring"]
Teeth = Mapping[str, Any]  # tooth numbers by wheel, numbers or arrays (n,)
Lengths = Sequence[Any]  # a value of every stage or mesh, arrays (n,)
Candidates = Callable[[Any, tuple[int, ...], Any], Iterator[Any]]  # (TrainTask, proportion, Tally) -> blocks


class MovingWheel(NamedTuple):
    """How a moving wheel is built."""

    shape: Shape
    widths: int = 1  # over the width of its stage


PINION, WHEEL, RING = MovingWheel("pinion"), MovingWheel("wheel"), MovingWheel("ring")


@record
class Mesh:
    """A pair of wheels in mesh; the one nearer to wheel 1 is named first."""

    first: str
    second: str
    stage: int  # 0, 1, ...: the module that it has
    internal: bool = False
    plane: int | None = None  # of meshing, along the axis; None: that of the stage


def mesh(first: str, second: str, stage: int, kind: str = "A", plane: int | None = None) -> Mesh:
    """A mesh by the letter of its kind, A external and I internal."""
    return Mesh(first, second, stage, kind == "I", plane)


def chained_ratio(teeth: Teeth) -> tuple[Any, Any]:
    """U of wheels that mesh by twos in their order: Z2 Z3.../(Z1 Z2'...) (4.2), numerator and denominator.

    >>> chained_ratio({"1": 22, "2": 118, "2'": 17, "3": 97})
    (11446, 374)
    """
    numbers = list(teeth.values())
    top, bottom = numbers[1], numbers[0]
    for driven, driver in zip(numbers[3::2], numbers[2::2], strict=True):
        top, bottom = top * driven, bottom * driver
    return top, bottom


def around_planets(teeth: Teeth, m: Lengths, stretch: Lengths, planets: int) -> Any:
    """D, the circle around the planets 2 (4.48); ``m`` [m] of the stages, ``stretch`` of the meshes."""
    return m[0] * ((teeth["1"] + teeth["2"]) * stretch[0] + teeth["2"])


@record
class Layout:
    """A layout of a gear train."""

    key: str  # the word of the spec
    title: str  # plain English
    designation: str  # of the textbook
    wheels: tuple[str, ...]
    meshes: tuple[Mesh, ...]
    candidates: Candidates  # tooth sets within limits, coaxiality and ratio for one proportion of modules
    moving: Mapping[str, MovingWheel]  # the wheels that move, as they are built
    sign: int = 0  # of U in i_1H = 1 + sign U: +1 or -1; 0: not of this form
    planets: tuple[str, ...] = ()  # wheels that the carrier bears, or that stand on layshafts
    rings: tuple[str, ...] = ()  # internal wheels
    planetary: bool = True
    fixed: str = ""  # the central wheel that stands still
    tooth_ratio: Callable[[Teeth], tuple[Any, Any]] = chained_ratio  # U, of AII i_14: numerator and denominator
    # numerators and denominators of what is whole if K equally spaced planets fit in; the last one is R (4.25, 4.26)
    assembly: Callable[[Teeth, int], list[tuple[Any, Any]]] | None = None
    ratio_letters: str = ""  # ``tooth_ratio`` as a formula; empty: that of `chained_ratio`
    assembly_letters: tuple[str, ...] = ()  # ``assembly`` as formulas
    # twice the reference centre distances of the axes that must coincide, in one length; None: those of the meshes
    axes: Callable[[Teeth], list[Any]] | None = None
    size: Callable[[Teeth, Lengths, Lengths, int], Any] = around_planets  # D [m], see `around_planets`
    size_letters: str = "2*a_12 + m_1*Z2"  # ``size`` as a formula with the centre distances a of the meshes
    lone_size_letters: str = ""  # the same of one branch, where it is another
    arrangements: tuple[int, ...] = ()  # rows of Table D.4.1 of the stages; none: overhung wheels
    stepped: bool = False  # the textbook steps through e, and gives the module ratio of equal strength
    usual_planets: int = 3
    usual_ratio: int | None = None  # tooth ratio up to which it is usual
    raised: float | None = None  # [rad] largest operating pressure angle where meshes are raised by custom
    carrier: Literal["left", "right"] = "right"  # of the wheels: where it is drawn; left: around the input shaft

    @property
    def stages(self) -> int:
        """Number of modules: meshes of one stage share theirs."""
        return 1 + max(mesh.stage for mesh in self.meshes)

    @property
    def branched(self) -> bool:
        """Whether the power may flow through several planets or layshafts in parallel."""
        return bool(self.planets)

    @property
    def single(self) -> bool:
        """Whether one planet wheel meshes with sun and ring."""
        return self.planetary and len(self.planets) == 1

    @property
    def paired(self) -> bool:
        """Whether planets mesh with one another."""
        return any(mesh.first in self.planets and mesh.second in self.planets for mesh in self.meshes)

    @property
    def common_axis(self) -> bool:
        """Whether it is two stages 1-2 and 2'-3 with a common axis."""
        return self.branched and len(self.wheels) == 4 and self.stages == 2

    @property
    def three_centrals(self) -> bool:
        """Whether it has three central wheels, so that its ratio is not 1 + U or 1 - U."""
        return self.planetary and not self.sign

    @property
    def output(self) -> str:
        """The output shaft: the carrier of a planetary train, the second ring of AII, the last wheel of fixed axes."""
        return CARRIER if self.sign else self.wheels[-1]

    def index(self, wheel: str) -> int:
        """Column of a wheel in arrays of tooth numbers."""
        return self.wheels.index(wheel)


@cache
def known_layouts() -> dict[str, Layout]:
    """The layouts by their keys; their files make candidates of teeth, so they are read when one is asked for."""
    found: dict[str, Layout] = import_module("tmmcalc.gears.layouts").LAYOUTS
    return found


@cache
def known_parts() -> dict[str, Layout]:
    """The layouts of parts of a drive beside its train, which no train is sought for."""
    found: dict[str, Layout] = import_module("tmmcalc.gears.layouts").PARTS
    return found


def layout_of(key: str) -> Layout:
    """The layout of this key; raises `UsageError` with the known ones.

    >>> layout_of("AI").title
    'double planets, external and internal mesh'
    """
    layouts = known_layouts()
    found = layouts.get(key) or known_parts().get(key)
    if found is not None:
        return found
    raise UsageError(f"no layout is called {key!r}", where="layout", remedy=f"layouts: {', '.join(layouts)}")
