"""The pairs of gears of a spec as they are written: ``[pair]`` itself, or each of ``[[pair.meshes]]`` on top of it."""

from __future__ import annotations

from math import pi

from tmmcalc.core.records import record
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.scheme import Mesh
from tmmcalc.gears.tables.checks.train import exact, written_layouts
from tmmcalc.gears.tables.shifting import usual_strategy
from tmmcalc.spec.outline import Outline, Raw, subtable, tables, word
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

KINDS = ("external", "internal", "rack")


@record
class Written:
    """One pair; of a train also what [pair] says for all its meshes."""

    path: Path  # of its own keys
    own: Raw
    general: Raw  # [pair], whose keys it takes where it has none
    kinds: tuple[str, ...]  # that it can be of; none: its kind is faulty
    rack: Rack  # that it has if nothing is said: the standard one, or that of the train
    of_train: bool

    @property
    def keys(self) -> Raw:
        """All that holds for it."""
        return {**self.general, **self.own}

    @property
    def kind(self) -> str:
        """Its kind, empty if that is not known."""
        return self.kinds[0] if len(self.kinds) == 1 else ""

    @property
    def strategy(self) -> str:
        """How its shifts are chosen."""
        return word(self.keys, "strategy") or usual_strategy(self.keys, self.kind or "external", self.of_train)

    def at(self, key: str) -> Path:
        """Place where a key of it is written."""
        return (*self.path, key) if key in self.own else ("pair", key)


def entries(outline: Outline) -> list[tuple[int, Raw]]:
    """The elements of [[pair.meshes]]."""
    return tables(subtable(outline.document, "pair"), "meshes")


def is_of_train(outline: Outline) -> bool:
    """Whether the pairs are those of the train: none has teeth of its own."""
    pair = subtable(outline.document, "pair")
    free = any("teeth" in entry and "mesh" not in entry for _, entry in entries(outline))
    return "train" in outline.document and "teeth" not in pair and not free


def mesh_name(mesh: Mesh) -> str:
    """A mesh by its wheels.

    >>> from tmmcalc.gears.scheme import layout_of
    >>> mesh_name(layout_of("AI").meshes[1])
    "2'-3"
    """
    return f"{mesh.first}-{mesh.second}"


def written_pairs(outline: Outline) -> list[Written]:
    """All pairs; of a train what is said for every mesh, and then its meshes that say more."""
    pair, found = subtable(outline.document, "pair"), entries(outline)
    if pair.get("meshes", []) != [] and not found:
        return []  # what is no list of tables is pydantic's to report
    places: list[tuple[Path, Raw]] = [(("pair", "meshes", index), entry) for index, entry in found]
    if not is_of_train(outline):
        alone = places or [(("pair",), pair)]
        return [Written(path, own, pair, _kind({**pair, **own}), Rack(), False) for path, own in alone]
    known, rack = (
        [mesh for layout in written_layouts(subtable(outline.document, "train")) for mesh in layout.meshes],
        _rack(outline),
    )
    every = [(("pair",), pair, known), *((path, own, _named(known, own.get("mesh"))) for path, own in places)]
    return [Written(path, own, pair, _kinds(meshes), rack, True) for path, own, meshes in every]


def _named(meshes: list[Mesh], name: object) -> list[Mesh]:
    return [mesh for mesh in meshes if mesh_name(mesh) == name]


def _rack(outline: Outline) -> Rack:
    """The rack of the train, as far as it can be read."""
    train = subtable(outline.document, "train")
    angle, addendum = amount(train.get("pressure_angle", pi / 9), "angle"), exact(train.get("addendum", 1))
    usual = Rack()
    return Rack(usual.angle if angle is None else angle, usual.addendum if addendum is None else float(addendum))


def _kinds(meshes: list[Mesh]) -> tuple[str, ...]:
    return tuple(sorted({"internal" if mesh.internal else "external" for mesh in meshes}))


def _kind(keys: Raw) -> tuple[str, ...]:
    kind = word(keys, "kind") if "kind" in keys else KINDS[0]
    return (kind,) if kind in KINDS else ()
