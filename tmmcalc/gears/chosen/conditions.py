"""Every condition of one tooth set with both its sides: ratio, common axis, assembly, neighbours, limits.

Whatever a search asks for is here a row with its formula, the formula with the numbers of the set, both sides and
whether it is kept; what is good custom but was not asked for is told as well, and marked.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from tmmcalc.gears.chosen.choice import Chosen
from tmmcalc.gears.chosen.condition import Condition, Conditions, Side, condition
from tmmcalc.gears.letters import teeth_of
from tmmcalc.gears.scheme import Layout, Mesh
from tmmcalc.gears.search import measures
from tmmcalc.gears.search.constraints import centre_distances, envelopes, neighbours


def conditions(chosen: Chosen) -> Conditions:
    """The conditions of a tooth set in the order of the textbook.

    >>> import numpy as np
    >>> from tmmcalc.gears.chosen.choice import written_set
    >>> from tmmcalc.gears.gearingtask import layout_task
    >>> found = conditions(written_set(layout_task("AI", (22, 118, 17, 97), 3)))
    >>> [each.numbers for each in found.conditions if each.name == "assembly"]
    ['(118*97 + 22*17)/(3*gcd(118, 17)) = 3940']
    """
    sets = chosen.sets
    return Conditions(
        sets.layout,
        sets.planets,
        tuple(sets.teeth[0].tolist()),
        tuple(mu for mu in sets.modules[0].tolist() if mu),
        tuple(_Listed(chosen).all()),
    )


class _Listed:
    """The conditions of one set, with the numbers of all letters."""

    def __init__(self, chosen: Chosen) -> None:
        self.chosen, self.task, self.scheme = chosen, chosen.task, chosen.sets.scheme
        self.teeth, self.block = chosen.teeth, measures.block_of(chosen.sets)
        self.raised = self.task.demands.largest_angle is not None and self.scheme.branched
        angles = zip(self.scheme.meshes, chosen.sets.angles[0].tolist(), strict=True)
        self.numbers: dict[str, float] = {
            **{teeth_of(wheel): z for wheel, z in self.teeth.items()},
            **{f"mu_{k}": part for k, part in enumerate(chosen.sets.modules[0].tolist(), 1)},
            **{_angle(mesh): angle for mesh, angle in angles},
            "K": chosen.sets.planets,
            "alpha": self.task.pressure_angle,
            "h_a": float(self.task.addendum),
        }

    def all(self) -> Iterator[Condition]:
        """In the order of the textbook: ratio, axes, assembly, neighbours; then limits of wheels and sizes."""
        yield from self.ratio()
        yield from self.axes()
        yield from self.assembly()
        yield from self.neighbours()
        yield from self.rings()
        yield from self.limits()
        yield from self.stages()
        yield from self.common_factors()
        yield from self.angles()
        yield from self.sizes()

    def put(
        self, name: str, left: Side, relation: str, right: Side, *, of: str = "", source: str = "", asked: bool = True
    ) -> Condition:
        """The condition of two sides with the numbers of their letters."""
        return condition(name, left, relation, right, self.numbers, of=of, source=source, asked=asked)

    def ratio(self) -> Iterator[Condition]:
        """The ratio of the kind that was asked for within both ends of its tolerance."""
        request = self.chosen.request
        if request is None:
            return
        u = Fraction(*(int(part[0]) for part in measures.tooth_ratio(self.chosen.sets)))
        letters, sign = ratio_letters(self.scheme), "+" if self.scheme.sign > 0 else "-"
        value = 1 + self.scheme.sign * u if request.kind in ("i_1H", "i_H1") else u
        if request.kind == "i_1H":
            letters = f"1 {sign} {letters}"
        elif request.kind == "i_H1":
            letters, value = f"1/(1 {sign} {letters})", 1 / value
        source = "(4.19)" if self.scheme.planetary else "(4.2), (4.6)"
        for name, relation, limit in (("least", ">=", request.admitted.low), ("largest", "<=", request.admitted.high)):
            bound = f"{request.kind}_{'min' if name == 'least' else 'max'}"
            self.numbers[bound] = float(limit)
            yield self.put("ratio", (letters, value), relation, (bound, limit), of=request.kind, source=source)

    def axes(self) -> Iterator[Condition]:
        """Meshes whose centre distances have to be alike."""
        if not self.scheme.branched:
            return
        if self.scheme.paired:
            first, second, third = (self._distance(mesh) for mesh in self.scheme.meshes)
            both = f"{first[0]} + {second[0]}", first[1] + second[1]
            yield self.put("coaxiality", both, "=", third, of="1-2, 2-3, 3-4", source="(2) of the article on 2A-AA")
            return
        source = "(4.24)" if self.scheme.single else "(4.10), (4.21)"
        start, *others = self.scheme.meshes
        for mesh in others:
            of = f"{_name(start)}, {_name(mesh)}"
            yield self.put("coaxiality", self._distance(start), "=", self._distance(mesh), of=of, source=source)

    def _distance(self, mesh: Mesh) -> Side:
        """Twice the operating centre distance in the unit of the proportion of modules."""
        letters, total = self._pair(mesh)
        stages = self.scheme.stages > 1
        mu = int(self.chosen.sets.modules[0, mesh.stage])
        letters, value = (f"mu_{mesh.stage + 1}*({letters})", mu * total) if stages else (letters, total)
        if not self.raised:
            return letters, value
        stretch = math.cos(self.task.pressure_angle) / math.cos(self.numbers[_angle(mesh)])
        return f"{letters if stages else f'({letters})'}*cos(alpha)/cos({_angle(mesh)})", value * stretch

    def _pair(self, mesh: Mesh) -> tuple[str, int]:
        """Sum of the teeth of a pair, of a ring and its planet the difference."""
        outer, inner = (mesh.first, mesh.second) if mesh.first in self.scheme.rings else (mesh.second, mesh.first)
        if mesh.internal:
            return f"{teeth_of(outer)} - {teeth_of(inner)}", self.teeth[outer] - self.teeth[inner]
        letters = f"{teeth_of(mesh.first)} + {teeth_of(mesh.second)}"
        return letters, self.teeth[mesh.first] + self.teeth[mesh.second]

    def assembly(self) -> Iterator[Condition]:
        """What is whole if equally spaced planets fit in."""
        if self.scheme.assembly is None or self.chosen.sets.planets < 2 or not self.scheme.branched:
            return
        source = "(1) of the article on 2A-AA" if self.scheme.paired else "(4.26)" if self.scheme.single else "(4.25)"
        terms = self.scheme.assembly(self.chosen.sets.by_wheel, self.chosen.sets.planets)
        for letters, (numerator, denominator) in zip(self.scheme.assembly_letters, terms, strict=True):
            value = Fraction(int(np.ravel(numerator)[0]), int(np.ravel(denominator)[0]))
            asked = self.task.demands.assembly
            self.numbers["R"] = round(value)
            yield self.put("assembly", (letters, value), "=", ("R", round(value)), source=source, asked=asked)

    def neighbours(self) -> Iterator[Condition]:
        """Neighbouring planets clear each other, where there are three or more."""
        if self.chosen.sets.planets < 3 or not self.scheme.branched:
            return
        gap, paired = self.task.demands.gap, self.scheme.paired
        self.numbers["gap"] = 0.0 if gap is None else float(gap)
        room = "2*h_a" if paired or not gap else "2*h_a + gap"
        for each in neighbours(self.task, self.block):
            stretched = f"*cos(alpha)/cos({_angle(each.mesh)})" if self.raised and not paired else ""
            across = f"({self._pair(each.mesh)[0]}){stretched}*sin(pi/K)", float(each.across[0])
            planet = self.teeth[each.planet]
            own = f"{teeth_of(each.planet)} + {room}", planet + each.tips
            relation, source = (">=", "(8) of the article on 2A-AA") if paired else (">", "(4.27), (4.28)")
            yield self.put(
                "adjacency", across, relation, own, of=f"planets {each.planet}", source=source, asked=gap is not None
            )

    def rings(self) -> Iterator[Condition]:
        """A ring has enough teeth more than the wheel in it."""
        least = self.task.demands.ring_difference
        self.numbers["d_min"] = 7 if least is None else least
        for mesh in self.scheme.meshes:
            if mesh.internal:
                right = "d_min", self.numbers["d_min"]
                yield self.put("interference", self._pair(mesh), ">=", right, of=_name(mesh), asked=least is not None)

    def limits(self) -> Iterator[Condition]:
        """Least and largest numbers of teeth; undercut."""
        rings = [wheel for wheel in self.scheme.wheels if wheel in self.scheme.rings]
        others = [wheel for wheel in self.scheme.wheels if wheel not in self.scheme.rings]
        limits, asked = self.task.limits, self.task.teeth is None
        rows = [("z_min", limits.least, ">=", others), ("z_max", limits.largest, "<=", others)]
        if rings:
            rows += [("ring_min", limits.least_ring, ">=", rings), ("ring_max", limits.largest_ring, "<=", rings)]
        if not self.scheme.branched:
            rows.append(("z_pinion_max", limits.largest_pinion, "<=", list(self.scheme.wheels[::2])))
        for name, limit, relation, wheels in rows if self.chosen.request is not None else ():
            self.numbers[name] = limit
            left = _extreme("min" if relation == ">=" else "max", [(teeth_of(w), self.teeth[w]) for w in wheels])
            yield self.put("teeth", left, relation, (name, limit), of=_wheels(wheels), asked=asked)
        if limits.largest_sum is not None:
            self.numbers["sum_max"] = limits.largest_sum
            total = "Z1 + Z2", self.teeth["1"] + self.teeth["2"]
            yield self.put("largest_sum", total, "<=", ("sum_max", limits.largest_sum), of="1, 2")
        smallest = _extreme("min", [(teeth_of(w), self.teeth[w]) for w in others])
        least = math.floor(2 * float(self.task.addendum) / math.sin(self.task.pressure_angle) ** 2)
        bound = "floor(2*h_a / sin(alpha)**2)", least
        asked = self.task.demands.undercut is not None
        yield self.put("undercut", smallest, ">=", bound, of=_wheels(others), asked=asked)

    def stages(self) -> Iterator[Condition]:
        """Ratios of single stages, equal pinions, diameters alike: of reducers with fixed axes."""
        demands = self.task.demands
        if demands.stage_ratio is not None and not self.scheme.planetary:
            self.numbers["u_max"] = float(demands.stage_ratio)
            for mesh in self.scheme.meshes:
                u = Fraction(self.teeth[mesh.second], self.teeth[mesh.first])
                left = f"{teeth_of(mesh.second)}/{teeth_of(mesh.first)}", u
                yield self.put("stage_ratio", left, "<=", ("u_max", demands.stage_ratio), of=_name(mesh))
        if demands.equal_pinions and not self.scheme.branched:
            first, *others = self.scheme.wheels[::2]
            for other in others:
                sides = [(teeth_of(wheel), self.teeth[wheel]) for wheel in (first, other)]
                yield self.put("equal_pinions", sides[0], "=", sides[1], of=f"{first}, {other}")
        if demands.diameter_band is not None and (self.scheme.common_axis or not self.scheme.branched):
            yield from self._diameters(float(demands.diameter_band))

    def _diameters(self, band: float) -> Iterator[Condition]:
        """How far the diameters of the wheels of neighbouring stages differ; of an unfolded train by (4.4)."""
        self.numbers["delta_d"] = band
        if self.scheme.branched:
            mu1, mu2 = self.chosen.sets.modules[0].tolist()
            value = abs(mu2 * self.teeth["3"] / (mu1 * self.teeth["2"]) - 1)
            yield self.put("diameter_band", ("abs(mu_2*Z3/(mu_1*Z2) - 1)", value), "<=", ("delta_d", band), of="2, 3")
            return
        names = self.scheme.wheels
        for k in range(1, self.scheme.stages):
            pinion, wide, wheel = names[2 * k - 2], names[2 * k - 1], names[2 * k + 1]
            z1, z2, z3 = (self.teeth[name] for name in (pinion, wide, wheel))
            one, two, three = map(teeth_of, (pinion, wide, wheel))
            left = f"abs(({two}/{one})**(1/3) * {three}/{two} - 1)", abs(float(np.cbrt(z2 / z1)) * z3 / z2 - 1)
            yield self.put("diameter_band", left, "<=", ("delta_d", band), of=f"{wide}, {wheel}", source="(4.4)")

    def common_factors(self) -> Iterator[Condition]:
        """No common factor of wheels in mesh: every tooth meets every other."""
        for mesh in self.scheme.meshes:
            one, other = self.teeth[mesh.first], self.teeth[mesh.second]
            left = f"gcd({teeth_of(mesh.first)}, {teeth_of(mesh.second)})", math.gcd(one, other)
            yield self.put("coprime", left, "=", ("1", 1), of=_name(mesh), asked=self.task.demands.coprime)

    def angles(self) -> Iterator[Condition]:
        """Operating pressure angles within their limit, where meshes are raised."""
        largest = self.task.demands.largest_angle
        if largest is None or not self.raised:
            return
        self.numbers["alpha_max"] = largest
        for mesh in self.scheme.meshes:
            left = _angle(mesh), self.numbers[_angle(mesh)]
            yield self.put("mesh_angles", left, "<=", ("alpha_max", largest), of=_name(mesh))

    def sizes(self) -> Iterator[Condition]:
        """Centre distance and envelope, where the module and a limit are given."""
        demands, module = self.task.demands, self.task.module
        if module is None:
            return
        if demands.centre_distance is not None:
            distance = "a_12", float(centre_distances(self.task, self.block)[0])
            self.numbers["a_12"] = distance[1]
            for bound, relation, limit in zip(("a_min", "a_max"), (">=", "<="), demands.centre_distance, strict=True):
                if limit is not None:
                    self.numbers[bound] = limit
                    yield self.put("centre_distance", distance, relation, (bound, limit), of="1-2")
        if demands.envelope is not None and self.scheme.branched:
            self.numbers |= {"D": float(envelopes(self.task, self.block)[0]), "D_max": demands.envelope}
            yield self.put("envelope", ("D", self.numbers["D"]), "<=", ("D_max", demands.envelope))


def ratio_letters(scheme: Layout) -> str:
    """The tooth ratio U of a layout as a formula; of AII that of i_14.

    >>> from tmmcalc.gears.scheme import layout_of
    >>> ratio_letters(layout_of("AI")), ratio_letters(layout_of("AIbar"))
    ("Z2*Z3/(Z1*Z2')", 'Z3/Z1')
    """
    if scheme.ratio_letters:
        return scheme.ratio_letters
    driven, drivers = ("*".join(map(teeth_of, scheme.wheels[k::2])) for k in (1, 0))
    return f"{driven}/({drivers})"


def _name(mesh: Mesh) -> str:
    return f"{mesh.first}-{mesh.second}"


def _angle(mesh: Mesh) -> str:
    return f"alpha_w{mesh.first}{mesh.second}"


def _wheels(names: list[str]) -> str:
    return ", ".join(names)


def _extreme(word: str, teeth: list[tuple[str, int]]) -> Side:
    """The least or largest of several numbers of teeth."""
    value = (min if word == "min" else max)(number for _, number in teeth)
    letters = ", ".join(letter for letter, _ in teeth)
    return (letters if len(teeth) == 1 else f"{word}({letters})"), value
