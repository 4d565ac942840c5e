"""What a stage offers to be seen, from the results of a run: its picture, what moves, what is tried by hand."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import TmmError
from tmmcalc.core.stage import STAGES, arguments, resolve
from tmmcalc.report.drawing.order import PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.report.rows import CHOOSE

if TYPE_CHECKING:
    from tmmcalc.report.drawing.shapes import Drawing
    from tmmcalc.report.sheets.piece import Piece

NONE = dict.fromkeys((POSITIONS, POLYGONS, CHOOSE, PHASE))  # no flags


def figure_of(
    stage: str, spec: Any, results: Mapping[str, Any], flags: Mapping[str, str | None] = NONE
) -> Callable[[], Drawing]:
    """What draws the picture of a stage that has one; ``flags`` are those of ``tmmcalc plot``."""
    picture = STAGES[stage].picture
    assert picture is not None
    order = order_of(spec, results, flags)
    draw: Callable[[Order], Drawing] = resolve(picture.figure)

    def drawn() -> Drawing:
        from tmmcalc.report.drawing.page import on_paper

        with on_paper(project=spec.project.title):
            return draw(order)

    return drawn


def pieces_of(stage: str, spec: Any, results: Mapping[str, Any]) -> list[Piece]:
    """What of the picture of a stage stands on sheets, in the language in force; none of a stage without any."""
    picture = STAGES[stage].picture
    if picture is None or not picture.pieces:
        return []
    offered: Callable[[Order], Iterable[Piece]] = resolve(picture.pieces)
    return list(offered(order_of(spec, results, NONE)))


def order_of(spec: Any, results: Mapping[str, Any], flags: Mapping[str, str | None] = NONE) -> Order:
    """What a picture or a chapter of a run is made from."""
    from tmmcalc.pipeline.runner import upstream_of
    from tmmcalc.project import parse_spec

    def solved(name: str) -> Any:
        own = STAGES[name]
        return own.solved(*arguments(own.inputs(spec)), **upstream_of(own, results))

    return Order(spec, results, flags, solved, parse_spec)


def offered(stage: str, what: str, order: Order) -> list[Any]:
    """The ``views`` or ``trials`` of a stage; none where it has none."""
    module = STAGES[stage].view
    offers: Callable[[Order], Iterable[Any]] | None = getattr(import_module(module), what, None) if module else None
    return [*offers(order)] if offers else []


def svg_of(stage: str, spec: Any, results: Mapping[str, Any]) -> str | None:
    """The picture of a stage as SVG; None if it has none, or if it cannot be drawn."""
    if STAGES[stage].picture is None:
        return None
    from tmmcalc.report.drawing import written

    try:
        return written("svg", figure_of(stage, spec, results)()).decode()
    except TmmError:
        return None
