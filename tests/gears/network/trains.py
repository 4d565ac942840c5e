"""Random trains for the tests of the network."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import strategies as st
from properties import examples

from tmmcalc.gears.network.model import Body, Mesh, Network

EXAMPLES = examples(60, derandomize=True, database=None)
TEETH = st.integers(12, 120)
ETA = st.floats(0.9, 1.0)
SIGN = st.sampled_from((-1, 1))


def mesh(draw: st.DrawFn, first: str, second: str) -> Mesh:
    return Mesh(first, draw(TEETH), second, draw(TEETH), draw(SIGN), draw(ETA))


def planetary_set(draw: st.DrawFn, tag: str, centrals: list[str], carrier: str) -> tuple[list[Mesh], list[Body]]:
    """Central members about a carrier, joined by a chain of planets: two degrees of freedom."""
    planets = [f"p{tag}{k}" for k in range(draw(st.integers(1, 2)))]
    meshes = [mesh(draw, a, b) for a, b in pairwise(planets)]
    meshes += [mesh(draw, central, draw(st.sampled_from(planets))) for central in centrals]
    count = draw(st.integers(1, 4))
    return meshes, [Body(planet, carrier, count) for planet in planets]


@st.composite
def sets(draw: st.DrawFn) -> Network:
    """One planetary set: nothing stands in the frame, two degrees of freedom."""
    centrals = [f"c{k}" for k in range(draw(st.integers(2, 4)))]
    meshes, bodies = planetary_set(draw, "a", centrals, "H")
    return Network(tuple(meshes), tuple(bodies))


@st.composite
def trains(draw: st.DrawFn) -> Network:
    """A set, perhaps a second one that shares two members with it, and ordinary pairs: two degrees of freedom."""
    meshes, bodies = planetary_set(draw, "a", ["c0", "c1", "c2"], "H")
    if draw(st.booleans()):
        shared, carrier = draw(st.permutations(["c0", "c1", "c2", "H"]))[:2]
        more, planets = planetary_set(draw, "b", [shared, "d0"], carrier)
        meshes, bodies = meshes + more, bodies + planets
    for k in range(draw(st.integers(0, 2))):
        meshes.append(mesh(draw, draw(st.sampled_from(["c0", "c1", "H"])), f"s{k}"))
    return Network(tuple(draw(st.permutations(meshes))), tuple(bodies))
