"""The layouts of gear trains: their wheels, meshes and kinematic ratio.

Wheels are named as in the textbook: 1 drives, 2 and 2' turn together, 3 (or 4) is the last. The letters of a planetary
train name its meshes, A external and I internal; the bar (``AIbar``) says that one single planet makes both.
The *tooth ratio* of a train is U = Z2 Z3 / (Z1 Z2') (4.2), always positive, with its modifications:

    AIbar  U = Z3/Z1        2A-AA  U = Z4/Z1        AII  i_14 = (1 + Z3/Z1)/(1 - Z3 Z2'/(Z2 Z4)), with its sign
"""

from __future__ import annotations

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record


@record
class Mesh:
    """A pair of wheels in mesh; the one nearer to wheel 1 is named first."""

    first: str
    second: str
    stage: int  # 0, 1, ...: the module that it has
    internal: bool = False


@record
class Layout:
    """A layout of a gear train."""

    key: str  # the word of the spec
    title: str  # plain English
    designation: str  # of the textbook
    wheels: tuple[str, ...]
    meshes: tuple[Mesh, ...]
    sign: int = 0  # of U in i_1H = 1 + sign U: +1 or -1; 0: not of this form
    planets: tuple[str, ...] = ()  # wheels that the carrier bears, or that stand on layshafts
    rings: tuple[str, ...] = ()  # internal wheels
    planetary: bool = True

    @property
    def stages(self) -> int:
        """Number of modules: meshes of one stage share theirs."""
        return 1 + max(mesh.stage for mesh in self.meshes)

    @property
    def branched(self) -> bool:
        """Whether the power may flow through several planets or layshafts in parallel."""
        return bool(self.planets)

    def index(self, wheel: str) -> int:
        """Column of a wheel in arrays of tooth numbers."""
        return self.wheels.index(wheel)


def _pair(first: str, second: str, stage: int, kind: str = "A") -> Mesh:
    return Mesh(first, second, stage, kind == "I")


_BLOCK = ("1", "2", "2'", "3")

LAYOUTS: dict[str, Layout] = {
    layout.key: layout
    for layout in (
        Layout(
            "unfolded2",
            "two stages in unfolded layout",
            "unfolded",
            _BLOCK,
            (_pair("1", "2", 0), _pair("2'", "3", 1)),
            planetary=False,
        ),
        Layout(
            "unfolded3",
            "three stages in unfolded layout",
            "unfolded",
            ("1", "2", "2'", "3", "3'", "4"),
            (_pair("1", "2", 0), _pair("2'", "3", 1), _pair("3'", "4", 2)),
            planetary=False,
        ),
        Layout(
            "coaxial",
            "two stages in coaxial layout",
            "coaxial",
            _BLOCK,
            (_pair("1", "2", 0), _pair("2'", "3", 1)),
            planets=("2", "2'"),
            planetary=False,
        ),
        Layout(
            "AIbar",
            "single planets between sun and ring",
            "AI\u0304",
            ("1", "2", "3"),
            (_pair("1", "2", 0), _pair("2", "3", 0, "I")),
            +1,
            ("2",),
            ("3",),
        ),
        Layout(
            "AI",
            "double planets, external and internal mesh",
            "AI",
            _BLOCK,
            (_pair("1", "2", 0), _pair("2'", "3", 1, "I")),
            +1,
            ("2", "2'"),
            ("3",),
        ),
        Layout(
            "AA",
            "double planets, two external meshes",
            "AA",
            _BLOCK,
            (_pair("1", "2", 0), _pair("2'", "3", 1)),
            -1,
            ("2", "2'"),
        ),
        Layout(
            "II",
            "double planets, two internal meshes",
            "II",
            _BLOCK,
            (_pair("1", "2", 0, "I"), _pair("2'", "3", 1, "I")),
            -1,
            ("2", "2'"),
            ("1", "3"),
        ),
        Layout(
            "AII",
            "double planets, a sun and two rings",
            "AII",
            ("1", "2", "2'", "3", "4"),
            (_pair("1", "2", 0), _pair("2", "3", 0, "I"), _pair("2'", "4", 1, "I")),
            0,
            ("2", "2'"),
            ("3", "4"),
        ),
        Layout(
            "2A-AA",
            "pairs of meshing planets between two suns",
            "2A-(AA\u0304)",
            ("1", "2", "3", "4"),
            (_pair("1", "2", 0), _pair("2", "3", 0), _pair("3", "4", 0)),
            +1,
            ("2", "3"),
        ),
    )
}


def layout_of(key: str) -> Layout:
    """The layout of this key; raises `UsageError` with the known ones.

    >>> layout_of("AI").title
    'double planets, external and internal mesh'
    """
    if key in LAYOUTS:
        return LAYOUTS[key]
    raise UsageError(f"no layout is called {key!r}", where="layout", remedy=f"layouts: {', '.join(LAYOUTS)}")
