"""The chapter on structure: links, pairs, mobility, groups."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.instant import turning_links
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.pieces import of_groups
from tmmcalc.linkage.structure import ROMAN, Group, Structure
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_count, tr_name
from tmmcalc.report.manuscript import Block, Line, Paragraph, Place, Table
from tmmcalc.report.telling import pictured


def blocks(order: Order) -> Iterator[Block]:
    """Tables of links and pairs, the mobility with numbers, the groups in the order of assembly, drawn apart."""
    mechanism, result = to_linkage(order.spec.linkage), order.results["structure"]
    yield Paragraph(tr("The links are listed in table {tab:links}, the kinematic pairs in table {tab:pairs}."))
    heads = (tr("Number"), tr("Link"), tr("Motion"), tr("Pairs"))
    yield Table(tr("Links"), heads, tuple(_links(mechanism, result)), key="links")
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
        yield from _groups(order, result)
    yield Paragraph(tr("The structural formula: {formula}.", formula=result.formula.replace("->", "→")))
    number = _roman(result.class_number)
    yield Paragraph(tr("The class of the mechanism is that of its highest group: class {number}.", number=number))


def _groups(order: Order, result: Structure) -> Iterator[Block]:
    """The groups as a table and as a picture."""
    count = tr_count(len(result.groups), "Assur group", "Assur groups")
    if result.driven is None:
        said = tr(
            "With the input link {link} on the frame as the mechanism of class I, the other links form {count} "
            "(table {tab:groups}, figure {fig:groups}).",
            link=result.input_link,
            count=count,
        )
    else:
        said = tr(
            "The drive acts between two moving links, so the group {group} holds it; the links form {count} "
            "(table {tab:groups}, figure {fig:groups}).",
            group=result.driven.name,
            count=count,
        )
    yield Paragraph(said)
    heads = (tr("Group"), tr("Links"), tr("Class"), tr("Order"), tr("Kind"), tr("Outer pairs"), tr("Inner pairs"))
    yield Table(tr("Assur groups"), heads, tuple(map(_described, result.groups)), key="groups")
    kinematics = order.solved("kinematics")
    cycle = whole_cycle(chain_of(to_linkage(order.spec.linkage), kinematics), kinematics)
    row = rows_shown(order, cycle.chain, kinematics)[0]
    yield pictured(of_groups(result, cycle, float(kinematics.x[row])), key="groups")


def _links(mechanism: Mechanism, result: Structure) -> Iterator[tuple[str, ...]]:
    for link in (FRAME, *(each.id for each in mechanism.links)):
        name = tr("frame") if link == FRAME else tr_name(result.names.get(str(link), "")) or "–"
        pairs = ", ".join(joint.name for joint in mechanism.joints if link in joint.links)
        yield str(link), name, _motion(mechanism, link), pairs


def _motion(mechanism: Mechanism, link: int) -> str:
    """How a link can move, by its joints."""
    if link == FRAME:
        return tr("fixed")
    if link not in turning_links(mechanism):
        return tr("translation")
    pivots = (joint for joint in mechanism.joints if joint.kind == "revolute" and set(joint.links) == {FRAME, link})
    return tr("rotation") if next(pivots, None) else tr("plane motion")


def _pair(links: tuple[int, int]) -> str:
    return "–".join(map(str, sorted(links)))


def _kind(kind: str) -> str:
    return tr("revolute") if kind == "revolute" else tr("prismatic")


def _described(group: Group) -> tuple[str, ...]:
    """A row of the table of groups."""
    links = ", ".join(map(str, group.links))
    pairs = ", ".join(group.outer), ", ".join(group.inner)
    return group.name, links, _roman(group.class_number), str(group.order), group.kind or "–", *pairs


def _roman(number: int) -> str:
    return ROMAN.get(number, str(number))
