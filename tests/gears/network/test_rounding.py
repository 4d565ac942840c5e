"""Estimated errors of speeds, torques, powers and efficiencies of random trains against exact fractions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise
from math import lcm

import numpy as np
import pytest
from bounding import accepted, assert_bounds

from tmmcalc.gears.gearing import Gearing, solve_gearing
from tmmcalc.gears.gearingtask import GearingTask
from tmmcalc.gears.network.builder import bevel_differential, network_of
from tmmcalc.gears.network.efficiency import efficiency
from tmmcalc.gears.network.model import FRAME, Body, Mesh, Network
from tmmcalc.gears.network.power import PowerFlow

SCENES = 320
PI = Fraction("3.14159265358979323846264338327950288419716939937510")
FEW = 200
LAYOUTS = {"AIbar": 3, "AI": 4, "AA": 4, "II": 4, "AII": 5, "2A-AA": 4, "unfolded3": 6, "coaxial": 4}
Exact = dict[str, list[Fraction]]


def _of_layout(rng: np.random.Generator) -> Network:
    """Those of small differences of tooth numbers have large ratios, lock themselves or nearly do."""
    layout = str(rng.choice(list(LAYOUTS)))
    teeth = rng.integers(12, 150, LAYOUTS[layout])
    if layout in ("AA", "II") and rng.random() < 0.6:
        teeth[2:] = teeth[1::-1] + rng.integers(-2, 3, 2)
    train = network_of(layout, [int(z) for z in teeth], int(rng.integers(1, 5)), float(rng.uniform(0.9, 1.0)), 1.1)
    return train.network


def _compound(rng: np.random.Generator) -> Network:
    """One or two sets that share members, ordinary pairs, efficiencies of their own or none below one."""

    def mesh(first: str, second: str) -> Mesh:
        eta = 1.0 if rng.random() < 0.2 else float(rng.uniform(0.85, 1.0))
        z1, z2 = (int(z) for z in rng.integers(12, 120, 2))
        return Mesh(first, z1, second, z2, int(rng.choice([-1, 1])), eta)

    def planetary(tag: str, centrals: list[str], carrier: str) -> tuple[list[Mesh], list[Body]]:
        planets = [f"p{tag}{k}" for k in range(int(rng.integers(1, 3)))]
        meshes = [mesh(a, b) for a, b in pairwise(planets)]
        meshes += [mesh(central, str(rng.choice(planets))) for central in centrals]
        return meshes, [Body(planet, carrier, int(rng.integers(1, 5))) for planet in planets]

    meshes, bodies = planetary("a", ["c0", "c1", "c2"], "H")
    if rng.random() < 0.5:
        shared, carrier = rng.permutation(["c0", "c1", "c2", "H"])[:2].tolist()
        more, planets = planetary("b", [shared, "d0"], carrier)
        meshes, bodies = meshes + more, bodies + planets
    meshes += [mesh(str(rng.choice(["c0", "c1", "H"])), f"s{k}") for k in range(int(rng.integers(0, 3)))]
    return Network(tuple(meshes), tuple(bodies))


def _task(rng: np.random.Generator) -> GearingTask:
    """Held and driven members, or two driven ones; torques, loads or powers known, or none."""
    kind = rng.random()
    if kind < 0.15:
        network = bevel_differential(*(int(z) for z in rng.integers(10, 40, 3)), 2, float(rng.uniform(0.9, 1.0)))
    else:
        network = _of_layout(rng) if kind < 0.6 else _compound(rng)
    names = rng.permutation([n for n in network.members if network.bearer(n) == FRAME]).tolist()
    speeds = {names[0]: float(rng.uniform(-300, 300))}
    if len(names) > 2:
        other = float(rng.choice([0.0, speeds[names[0]] * rng.choice([1 + 1e-6, 0.5, -3.0])]))
        speeds[names[1]] = other
    last = names[-1]
    amount = float(10 ** rng.uniform(-2, 4))
    known = [{}, {"torques": {names[0]: amount}}, {"loads": {last: amount}}, {"powers": {last: -amount}}]
    return GearingTask(network, speeds, outputs=(last,), **known[rng.integers(4)])


def _speeds(network: Network, task: GearingTask) -> dict[str, Fraction]:
    """Exact speeds of all members from Willis's equations."""
    place = {name: k for k, name in enumerate(network.members)}
    rows, right = [], []
    for mesh, carrier in zip(network.meshes, network.carriers, strict=True):
        row = [Fraction()] * len(place)
        for name, z in ((mesh.first, mesh.first_teeth), (mesh.second, -mesh.sign * mesh.second_teeth)):
            row[place[name]] += z
            if carrier != FRAME and not network.tilted(name):
                row[place[carrier]] -= z
        rows.append(row)
        right.append(Fraction())
    for name, speed in task.speeds.items():
        rows.append([Fraction(member == name) for member in place])
        right.append(Fraction(speed))
    return dict(zip(place, _solved(rows, right), strict=True)) | {FRAME: Fraction()}


def _solved(rows: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """A consistent system of full column rank, by Gauss and Jordan."""
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    n = len(rows[0])
    for column in range(n):
        pivot = next(k for k in range(column, len(table)) if table[k][column])
        table[column], table[pivot] = table[pivot], table[column]
        table[column] = [each / table[column][column] for each in table[column]]
        for k, row in enumerate(table):
            if k != column and row[column]:
                table[k] = [a - row[column] * b for a, b in zip(row, table[column], strict=True)]
    return [row[n] for row in table[:n]]


def _exact(network: Network, flow: PowerFlow, speeds: dict[str, Fraction], known: dict[str, Fraction]) -> Exact:
    """Torques and powers by the equilibrium of every member, losses in the directions that were found."""
    place = {name: k for k, name in enumerate(network.members)}
    m, n = len(network.meshes), len(place)
    sought = [name for name, torque in zip(place, flow.torques.tolist(), strict=True) if torque and name not in known]
    rows = [[Fraction()] * (m + len(sought)) for _ in range(n)]
    shares = []
    for j, (mesh, carrier) in enumerate(zip(network.meshes, network.carriers, strict=True)):
        eta = Fraction(mesh.efficiency)
        if flow.losses[j] == 0:
            eta = Fraction(1)
        passed = eta if flow.rolling[j] > 0 else 1 / eta
        second = -Fraction(mesh.sign * mesh.second_teeth, mesh.first_teeth) * passed
        both = {mesh.first: Fraction(1), mesh.second: second}
        share = [Fraction(1), second, -sum(part for name, part in both.items() if not network.tilted(name))]
        shares.append(share)
        for name, part in zip((mesh.first, mesh.second, carrier), share, strict=True):
            if name != FRAME:
                rows[place[name]][j] += part
    for k, name in enumerate(sought):
        rows[place[name]][m + k] = Fraction(1)
    x = _solved(rows, [-known.get(name, Fraction()) for name in place])
    torques = [dict(zip(sought, x[m:], strict=True)).get(name, known.get(name, Fraction())) for name in place]
    powers = [torque * speeds[name] for torque, name in zip(torques, place, strict=True)]
    meshes, mesh_powers, rolling, losses = [], [], [], []
    for first, share, mesh, carrier in zip(x[:m], shares, network.meshes, network.carriers, strict=True):
        three = [first * part for part in share]
        meshes += three
        mesh_powers += [t * speeds[name] for t, name in zip(three, (mesh.first, mesh.second, carrier), strict=True)]
        against = [speeds[n] - (0 if network.tilted(n) else speeds[carrier]) for n in (mesh.first, mesh.second)]
        into = [t * w for t, w in zip(three, against, strict=False)]
        source = -into[0] if into[0] <= 0 else into[1]
        rolling.append(source)
        losses.append(abs(source) * (1 - Fraction(mesh.efficiency)))
    return {"torques": torques + meshes, "powers": powers + mesh_powers + rolling + losses, "outside": powers}


def _far(told: np.ndarray, exact: list[Fraction], size: Fraction | None = None) -> float:
    scale = max(map(abs, exact)) if size is None else size
    if not scale:
        return 0.0
    return float(max(abs(Fraction(float(a)) - b) for a, b in zip(np.ravel(told), exact, strict=True)) / scale)


def _known(task: GearingTask, found: Gearing, speeds: dict[str, Fraction]) -> dict[str, Fraction]:
    """Outside torques that are given; 1 N*m on the driver without any."""
    torques = {name: Fraction(torque) for name, torque in task.torques.items()}
    for name, load in task.loads.items():
        torques[name] = -Fraction(load) * (1 if speeds[name] > 0 else -1)
    for name, power in task.powers.items():
        torques[name] = Fraction(power) / speeds[name]
    if not torques:
        assert found.input is not None
        torques[found.input] = Fraction(1 if speeds[found.input] > 0 else -1)
    return torques


def _scenes(count: int) -> Iterator[tuple[str, float, float]]:
    rng = np.random.default_rng(11)
    for found in accepted(lambda: solve_gearing(_task(rng)), count):
        task = found.task
        network, error = task.network, found.error
        speeds = _speeds(network, task)
        yield "speeds", error["speeds"], _own([(found.motion.speed(n), speeds[n]) for n in network.members])
        yield "frequencies", error["frequencies"], _own(_frequencies(found, speeds))
        yield from _ways(found, speeds)
        if found.flow is None:
            continue
        flow, exact = found.flow, _exact(network, found.flow, speeds, _known(task, found, speeds))
        told = np.concatenate((flow.torques, flow.mesh_torques.ravel()))
        yield "torques", error["torques"], _far(told, exact["torques"])
        told = np.concatenate((flow.powers, flow.mesh_powers.ravel(), flow.rolling, flow.losses))
        yield "powers", error["powers"], _far(told, exact["powers"])
        given = sum(power for power in exact["outside"] if power > 0)
        if flow.efficiency is not None:
            eta = -sum(power for power in exact["outside"] if power < 0) / given
            yield "efficiency", error["efficiency"], _far(np.array([flow.efficiency]), [eta], max(eta, Fraction(1)))


def _frequencies(found: Gearing, speeds: dict[str, Fraction]) -> Iterator[tuple[float, Fraction]]:
    network, told = found.task.network, found.frequencies
    for name, turns in zip(network.members, told.shafts.tolist(), strict=True):
        yield turns, abs(speeds[name]) / (2 * PI)
    for j, (mesh, carrier) in enumerate(zip(network.meshes, network.carriers, strict=True)):
        against = speeds[mesh.first] - (0 if network.tilted(mesh.first) else speeds[carrier])
        rate = abs(against) * mesh.first_teeth / (2 * PI)
        yield float(told.mesh[j]), rate
        yield float(told.hunting[j]), rate / lcm(mesh.first_teeth, mesh.second_teeth)


def _ways(found: Gearing, speeds: dict[str, Fraction]) -> Iterator[tuple[str, float, float]]:
    """Efficiencies of both directions of the power, those of trains that lock themselves too."""
    network, held = found.task.network, [name for name, speed in found.task.speeds.items() if not speed]
    for way in found.ways:
        flow = efficiency(network, way.driver, way.output, held).flow
        unit = {name: speed / speeds[way.driver] for name, speed in speeds.items()}
        outside = _exact(network, flow, unit, {way.driver: Fraction(1)})["outside"]
        eta = -outside[network.place[way.output]]
        yield "ways", way.error, _far(np.array([way.efficiency]), [eta], max(abs(eta), Fraction(1)))


def _own(pairs: Iterable[tuple[float, Fraction]]) -> float:
    """Largest error of numbers, each relative to itself."""
    return float(max((abs(Fraction(a) - b) / abs(b) for a, b in pairs if b), default=Fraction()))


@pytest.mark.parametrize(("scenes", "few"), [(40, 20), pytest.param(SCENES, FEW, marks=pytest.mark.slow)])
def test_estimates_of_trains_in_motion(scenes: int, few: int) -> None:
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for name, estimate, error in _scenes(scenes):
        pairs[name].append((estimate, error))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=few)
