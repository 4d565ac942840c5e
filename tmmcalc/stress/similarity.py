"""A spec in other units of length, mass and time: every quantity of its document by the dimension of its field.

The tables of the spec say which number is a length and which a moment, so this needs no list of keys; defaults that
have a dimension, such as the acceleration of free fall, are written out.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from tmmcalc.cams.tables.cam_spring import spring_method
from tmmcalc.core.errors import UsageError
from tmmcalc.project.root import Spec
from tmmcalc.spec.choices import Listed, OneOrMore, OrFalse, Within
from tmmcalc.spec.deferred import DeferredTable
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.quantities import PolarForm, QualityGrade, Quantity
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import UnitError, parse
from tmmcalc.stress.units import Factors

Document = Mapping[str, Any]

LINEAR = {"length", "speed", "acceleration", "force", "mass", "stiffness", "damping", "quadratic damping"}
BOUND: dict[str, str] = {
    "train": "modules are standard, and strength is empirical",
    "strength": "modules are standard, and strength is empirical",
    "criteria": "modules are standard, and strength is empirical",
    "reliability": "it has no lengths",
    "transloader": "its usual speeds and capacities are in SI",
    "falling_ball": "its laws are formulas in SI",
    "indexing": "its search is set in metres",
    "engine": "what is balanced is zero but for rounding",
    "constraints": "their limits would have to follow",
}


class _Scale:
    def __init__(self, document: Document, factors: Factors) -> None:
        self.factors = factors
        mechanism = document.get("mechanism", {})
        driven = mechanism.get("input", {}).get("joint")
        kinds = {joint.get("name"): joint.get("kind") for joint in mechanism.get("joints", ())}
        self.slides = kinds.get(driven) == "prismatic"
        follower = document.get("cam", {}).get("follower")
        self.rocker, self.flat = follower == "oscillating", follower == "flat"

    def table(self, cls: type[BaseModel], value: Document, root: str = "") -> dict[str, Any]:
        found = dict(value)
        for name, field in cls.model_fields.items():
            key = field.alias or name
            place = root or key
            if key in value:
                found[key] = self.value(field.annotation, field.metadata, value[key], value, place)
            elif (name not in _useless(cls.__name__, value, self.flat)) and (
                default := self._default(field, value, place)
            ):
                found[key] = default
        if cls.__name__ == "PolynomialTable":
            found |= {key: [c * self.factors.of("N" if key == "force" else "N*m") for c in value[key]] for key in value}
        if cls.__name__ == "TorqueTable" and "formula" in value:
            found["formula"] = f"{self.factors.of('N*m')!r}*({value['formula']})"
        return found

    def value(self, annotation: Any, metadata: Any, value: Any, parent: Document, root: str) -> Any:
        """A value of an annotation, in the new units."""
        for each in metadata:
            if isinstance(each, DeferredTable):
                return self.table(each.table, value, root)
            if isinstance(each, PolarForm) and isinstance(value, dict):
                return {**value, "length": self.leaf(Quantity("length"), value["length"], parent, root)}
            if isinstance(each, Reader):
                return self.leaf(each, value, parent, root)
        origin, args = get_origin(annotation), get_args(annotation)
        if origin is Annotated:
            return self.value(args[0], args[1:], value, parent, root)
        if origin in (Union, UnionType):
            arm = _arm(args, value)
            return value if arm is None else self.value(arm, (), value, parent, root)
        if origin is list and isinstance(value, list):
            return [self.value(args[0], (), each, parent, root) for each in value]
        if origin is dict and isinstance(value, dict):
            return {key: self.value(args[1], (), each, parent, root) for key, each in value.items()}
        if isinstance(annotation, type) and issubclass(annotation, BaseModel) and isinstance(value, dict):
            return self.table(annotation, value, root)
        return value

    def leaf(self, reader: Reader, value: Any, parent: Document, root: str) -> Any:
        """A quantity, as text with its SI unit; what has no dimension stays as it is."""
        if isinstance(reader, OrFalse):
            return value if value is False else self.leaf(reader.item, value, parent, root)
        if isinstance(reader, Listed | OneOrMore) and isinstance(value, list):
            return [self.leaf(reader.item, each, parent, root) for each in value]
        if isinstance(reader, OneOrMore):
            return self.leaf(reader.item, value, parent, root)
        if isinstance(reader, QualityGrade):
            return reader.read(value) * self.factors.of("m/s")
        if not isinstance(value, str) and value == 0:  # in every unit
            return value
        quantity = reader.quantity if isinstance(reader, Within) else reader
        if not isinstance(quantity, Quantity) or value in quantity.words or isinstance(value, bool):
            return value
        dimension = self._dimension(quantity, value, parent, root)
        unit = DIMENSIONS[dimension].si
        factor = self.factors.of(unit)
        return value if factor == 1 else f"{parse(value, dimension) * factor!r} {unit}"

    def _dimension(self, quantity: Quantity, value: Any, parent: Document, root: str) -> str:
        if len(quantity.dimensions) == 1:
            return quantity.dimensions[0]
        if isinstance(value, str):
            return next(each for each in quantity.dimensions if _is(value, each))
        if {"angle", "moment"} == set(quantity.dimensions):
            raise UsageError(
                "straight pieces of a torque are given as bare numbers", remedy="write them with their units"
            )
        linear = self._linear(quantity, parent, root)
        return next(each for each in quantity.dimensions if (each in LINEAR) == linear)

    def _linear(self, quantity: Quantity, parent: Document, root: str) -> bool:
        """Whether a bare number is of a translation, where a rotation could be meant too."""
        if root == "cam":
            return not self.rocker
        if root == "springs":
            return parent.get("kind") != "torsion"
        if root == "manipulator":
            return _slides(parent)
        if root == "loads" and "damping" in quantity.dimensions[0]:
            return "point" in parent
        return self.slides or parent.get("of") == "displacement"

    def _default(self, field: FieldInfo, parent: Document, root: str) -> Any:
        """A default with a dimension, in the new units; None where there is none to be written."""
        default, made = field.default, field.default_factory
        if isinstance(made, type) and issubclass(made, BaseModel):
            return self.table(made, {}, root)
        if default is PydanticUndefined or isinstance(default, bool) or not isinstance(default, int | float):
            return None
        found = self.value(field.annotation, field.metadata, default, parent, root) if default else default
        return None if found == default else found


_OF_FILES = ("tolerance",)  # of exported curves, which no result knows
_UNDER_A_FACE = {"CamLimitsTable": ("concave_radius",), "CamRequirementsTable": ("roller_density",)}


def _useless(table: str, value: Document, flat: bool) -> tuple[str, ...]:
    """Defaults that are of no use beside the other keys of a table: written out they would be faults."""
    if table == "CamSpringTable":
        asked = value.get("method") or spring_method(value)
        unused = () if "wire" in value else ("shear_modulus",)
        return unused if asked == "preload" else (*unused, "least_contact")
    return _OF_FILES if table == "CamTable" else _UNDER_A_FACE.get(table, ()) if flat else ()


def in_units(document: Document, factors: Factors) -> dict[str, Any]:
    """The document of a spec in units that differ by ``factors``; raises UsageError for a scene that cannot be told."""
    for table, reason in BOUND.items():
        if table in document:
            raise UsageError(f"[{table}]: {reason}", where="scale")
    gearing = document.get("gearing", {"load": {}})
    if not {"torques", "powers", "load"} & set(gearing):
        raise UsageError("its train has no torque, and the program takes one of 1 N*m", where="scale")
    if document.get("motor", {}).get("name"):
        raise UsageError("the motor is one of a catalogue", where="scale")
    return _Scale(document, factors).table(Spec, document)


def _slides(joint: Document) -> bool:
    """Whether a joint of a manipulator slides, by the unit of its speed or acceleration."""
    told = next((joint[key] for key in ("speed", "acceleration") if isinstance(joint.get(key), str)), None)
    if told is None:
        raise UsageError("joints are given as bare numbers", where="scale", remedy="write them with their units")
    return _is(told, "speed") or _is(told, "acceleration")


def _arm(args: tuple[Any, ...], value: Any) -> Any:
    """The alternative of a union that a value is of."""
    arms = [arm for arm in args if arm is not NoneType and get_origin(arm) is not Literal]
    tables = [arm for arm in arms if isinstance(arm, type) and issubclass(arm, BaseModel)]
    if isinstance(value, dict) and tables:
        kinds = [arm for arm in tables if value.get("kind") in get_args(_kind(arm))]
        return (kinds or tables)[0]
    fitting = [arm for arm in arms if arm not in tables]
    lists = [arm for arm in fitting if get_origin(_bare(arm)) is list]
    return (lists if isinstance(value, list) and lists else [*fitting, None])[0]


def _bare(annotation: Any) -> Any:
    return get_args(annotation)[0] if get_origin(annotation) is Annotated else annotation


def _kind(table: type[BaseModel]) -> Any:
    field = table.model_fields.get("kind")
    return None if field is None else field.annotation


def _is(value: str, dimension: str) -> bool:
    try:
        parse(value, dimension)
    except UnitError:
        return False
    return True
