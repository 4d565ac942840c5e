"""The chapter on structure: links, pairs, mobility, groups."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.structure import ROMAN, Group, Structure
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_count, tr_name
from tmmcalc.report.manuscript import Block, Line, Listing, Paragraph, Place, Table


def blocks(order: Order) -> Iterator[Block]:
    """Tables of links and pairs, the mobility with numbers, the groups in the order of assembly."""
    mechanism, result = to_linkage(order.spec.linkage), order.results["structure"]
    yield Paragraph(tr("The links are listed in table {tab:links}, the kinematic pairs in table {tab:pairs}."))
    yield Table(tr("Links"), (tr("Number"), tr("Link"), tr("Pairs")), tuple(_links(mechanism, result)), key="links")
    yield Table(
        tr("Kinematic pairs"),
        (tr("Kinematic pair"), tr("Links"), tr("Kind"), tr("Class")),
        tuple((joint.name, _pair(joint.links), _kind(joint.kind), "5") for joint in mechanism.joints),
        key="pairs",
    )
    yield Paragraph(tr("The mobility of the mechanism by the formula of Chebyshev"))
    lexicon = {
        "W": Given(float(result.mobility), "", tr("mobility")),
        "n": Given(float(result.links), "", tr("number of moving links")),
        "p_5": Given(float(result.joints), "", tr("number of lower pairs")),
    }
    yield Line(read("W = 3*n - 2*p_5"), (Place("", lexicon),), key="mobility")
    if result.groups:
        count = tr_count(len(result.groups), "Assur group", "Assur groups")
        yield Paragraph(tr("Without the input link the mechanism falls into {count}:", count=count))
        yield Listing(tuple(map(_described, result.groups)))
    formula = result.formula.replace("->", "→")
    told = {"formula": formula, "number": ROMAN.get(result.class_number, str(result.class_number))}
    yield Paragraph(tr("The structural formula: {formula}. The class of the mechanism is {number}.", **told))


def _links(mechanism: Mechanism, result: Structure) -> Iterator[tuple[str, ...]]:
    for link in (FRAME, *(each.id for each in mechanism.links)):
        name = tr("frame") if link == FRAME else tr_name(result.names.get(str(link), ""))
        yield str(link), name, ", ".join(joint.name for joint in mechanism.joints if link in joint.links)


def _pair(links: tuple[int, int]) -> str:
    return "–".join(map(str, sorted(links)))


def _kind(kind: str) -> str:
    return tr("revolute") if kind == "revolute" else tr("prismatic")


def _described(group: Group) -> str:
    links = ", ".join(map(str, group.links))
    values = {
        "links": links,
        "number": ROMAN.get(group.class_number, str(group.class_number)),
        "order": group.order,
        "outer": ", ".join(group.outer),
        "inner": ", ".join(group.inner),
    }
    if not group.kind:
        return tr("links {links}: class {number}, order {order}, outer pairs {outer}, inner pairs {inner}", **values)
    return tr(
        "links {links}: class {number}, order {order}, kind {kind}, outer pairs {outer}, inner pair {inner}",
        kind=group.kind,
        **values,
    )
