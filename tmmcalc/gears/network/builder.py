"""Networks of the known layouts of trains, and of a bevel differential."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.network.efficiency import DriveEfficiency, efficiency
from tmmcalc.gears.network.model import EXTERNAL, FRAME, INTERNAL, WHERE, Body, Mesh, Network
from tmmcalc.gears.network.power import PowerFlow, solve_power
from tmmcalc.gears.network.speeds import ratio
from tmmcalc.gears.scheme import CARRIER, Layout, layout_of


@record
class Train:
    """A network in use: one member drives, one is driven, others are held."""

    network: Network
    driver: str
    output: str
    fixed: tuple[str, ...] = ()

    def reversed(self) -> Train:
        """The same train driven from the other end."""
        return Train(self.network, self.output, self.driver, self.fixed)


def network_of(
    layout: str,
    teeth: Sequence[int],
    planets: int = 1,
    efficiency: float | Sequence[float] = 1.0,
    sharing: float = 1.0,
) -> Train:
    """The train of a layout with these tooth numbers, in the order of the layout's wheels; wheel 1 drives.

    ``planets`` K counts planets or layshafts with their load-sharing factor ``sharing``; ``efficiency`` is that of each
    mesh, or one for all [-]. Raises `UsageError` for wrong counts.

    >>> train = network_of("AI", (22, 118, 17, 97), planets=3)
    >>> train.driver, train.output, train.fixed, ratio_of(train)
    ('1', 'H', ('3',), Fraction(5910, 187))
    """
    scheme = layout_of(layout)
    z = dict(zip(scheme.wheels, _counted(scheme, "wheels", teeth), strict=True))
    etas = (efficiency,) * len(scheme.meshes) if isinstance(efficiency, (int, float)) else efficiency
    meshes = tuple(
        Mesh(
            _member(pair.first),
            int(z[pair.first]),
            _member(pair.second),
            int(z[pair.second]),
            INTERNAL if pair.internal else EXTERNAL,
            float(eta),
        )
        for pair, eta in zip(scheme.meshes, _counted(scheme, "meshes", etas), strict=True)
    )
    carrier = CARRIER if scheme.planetary else FRAME
    borne = dict.fromkeys(_member(wheel) for wheel in scheme.planets)
    network = Network(meshes, tuple(Body(name, carrier, planets, sharing=sharing) for name in borne))
    return Train(network, scheme.wheels[0], scheme.output, (scheme.fixed,) if scheme.fixed else ())


def _member(wheel: str) -> str:
    """Wheels 2 and 2' are one member."""
    return wheel.rstrip("'")


def _counted(scheme: Layout, what: str, values: Sequence[float]) -> Sequence[float]:
    needed = len(scheme.wheels) if what == "wheels" else len(scheme.meshes)
    if len(values) == needed:
        return values
    raise UsageError(
        f"layout {scheme.key} has {needed} {what}, {len(values)} numbers are given",
        where=WHERE,
        value=float(len(values)),
        limit=float(needed),
        remedy=f"wheels {', '.join(scheme.wheels)}; meshes {', '.join(f'{m.first}-{m.second}' for m in scheme.meshes)}",
    )


def bevel_differential(
    left: int, planet: int, right: int, planets: int = 2, efficiency: float = 1.0, sharing: float = 1.0
) -> Network:
    """A bevel differential of members ``left``, ``right``, ``planet`` and carrier ``H``.

    >>> from tmmcalc.gears.network.speeds import solve_speeds
    >>> solve_speeds(bevel_differential(16, 10, 16), {"left": 30.0, "right": 10.0}).speed("H")
    20.0
    """
    meshes = (
        Mesh("left", left, "planet", planet, +1, efficiency),
        Mesh("right", right, "planet", planet, -1, efficiency),
    )
    return Network(meshes, (Body("planet", CARRIER, planets, tilted=True, sharing=sharing),))


def ratio_of(train: Train) -> Fraction:
    """Exact ratio of the driver's speed to the output's; raises as `ratio` does."""
    return ratio(train.network, train.driver, train.output, train.fixed)


def efficiency_of(train: Train) -> DriveEfficiency:
    """Efficiency from the driver to the output; raises as `efficiency` does."""
    return efficiency(train.network, train.driver, train.output, train.fixed)


def flow_of(train: Train, speed: float, load: float) -> PowerFlow:
    """Torques and powers for the driver's speed [rad/s] and the outside torque on the output [N*m].

    A load against the motion has the sign opposite to the output's speed. Raises as `solve_power` does.
    """
    speeds = {**dict.fromkeys(train.fixed, 0.0), train.driver: speed}
    return solve_power(train.network, speeds, {train.output: load})
