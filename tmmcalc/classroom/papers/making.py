"""Papers of a whole class: each variant is run once and its papers are written, in processes side by side."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.batch.choice import local
from tmmcalc.batch.local import available, cores
from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.task import Row, Task, verdict
from tmmcalc.classroom.draws import Drawn, drawn_of, spans
from tmmcalc.classroom.model import Item
from tmmcalc.classroom.papers.tasksheet import Mark, Own, given_of, mark_of, meanings_of, task_sheet
from tmmcalc.core.atomic import blamed_on, replace_file
from tmmcalc.core.errors import NoSolutionError, TmmError
from tmmcalc.core.stage import resolve
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.forms import formed
from tmmcalc.note.made import frame_of as frame_of_note
from tmmcalc.note.made import note_of, told_in
from tmmcalc.note.task import row_of
from tmmcalc.pipeline.chapters import given_in, task_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.report.language import speaking, spoken, tr
from tmmcalc.report.manuscript import Block, Datum
from tmmcalc.report.printing import printing
from tmmcalc.spec.override import split

if TYPE_CHECKING:
    from tmmcalc.classroom.state import Variant
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

SOLVER = "tmmcalc.classroom.papers.making:solve_papers"
FEW = 4  # papers that are not worth a process

Telling = Callable[[Any, Mapping[str, Any]], list[Block]]  # what is given, by a spec and its results
Data = dict[Mark, tuple[str, str, str]]  # as they are printed: the last digits of a number are nobody's own


class Order(NamedTuple):
    """A paper that is to be made, as it is sent to another process."""

    point: int  # number of the variant
    student: str
    assignments: tuple[str, ...]
    items: tuple[Item, ...]
    target: str  # the file; its suffix is the form
    language: str
    maker: str  # (scene, order) -> bytes, "module:function"
    own: Own = frozenset()  # data that variants differ in
    further: tuple[int, ...] = ()  # drawn numbers by place that the data do not tell

    @property
    def untold(self) -> dict[str, str]:
        """Keys and values of these numbers."""
        values = (split(self.assignments[at]) for at in self.further)
        return {key: value.strip('"') for key, value in values}


def order_of(
    variant: Variant,
    items: Sequence[Item],
    target: Path,
    maker: str,
    own: Own = frozenset(),
    further: tuple[int, ...] = (),
) -> Order:
    """The paper of a variant of a class, in the language in force."""
    return Order(
        variant.number,
        variant.student,
        variant.assignments,
        tuple(items),
        str(target),
        spoken(),
        maker,
        own,
        further,
    )


class Scene(NamedTuple):
    """A variant that was run."""

    spec: Spec
    run: RunResult
    folder: Path  # of the assignment


def solve_papers(task: Task, orders: Sequence[Order]) -> list[Row]:
    """Make each paper and write it; a row without numbers says that it is there, or why not."""
    variants = task.variants()
    return [_row(variants, order) for order in orders]


def make_papers(
    assignment: Path,
    orders: Sequence[Order],
    *,
    jobs: int | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Callable[[int], None] = lambda done: None,
) -> None:
    """Make the papers of these orders. Raises NoSolutionError for one that cannot be made."""
    task = Task(read_text(assignment), str(assignment), str(assignment.parent), (), (), solver=SOLVER, block=1)
    for folder in {Path(order.target).parent for order in orders}:
        with blamed_on(folder, "made"):
            folder.mkdir(parents=True, exist_ok=True)
    processes = jobs or (cores() if len(orders) > FEW and available() else 1)
    done = 0
    for rows in local(processes, tell)(task, [[order] for order in orders]):
        for row in rows:
            if not row.ok:
                raise NoSolutionError(
                    row.reason, where=f"variant {row.point}", remedy="make the class anew: class make --fresh"
                )
        done += len(rows)
        told(done)


def _row(variants: Variants, order: Order) -> Row:
    try:
        spec = variants.spec(order.assignments)
        make: Callable[[Scene, Order], bytes] = resolve(order.maker)
        units = spec.note.units if spec.note is not None else ()
        with speaking(order.language), printing(units):
            replace_file(Path(order.target), make(_scene(variants, spec), order))
    except Exception as error:  # one variant that breaks the program must not end the others
        return Row(order.point, *verdict(error))
    return Row(order.point, *verdict(None))


def _scene(variants: Variants, spec: Spec) -> Scene:
    return Scene(spec, run(spec), variants.folder)


def sheet_bytes(scene: Scene, order: Order) -> bytes:
    """The task sheet of a variant in the form of its file."""
    with scene.run.believed():
        blocks = given_in(scene.run.spec, scene.run.results)
        given = given_of(blocks, order.own, order.untold)
        meanings = meanings_of(order.items, scene.run)
        title, form = scene.spec.project.title, Path(order.target).suffix[1:]
        written = Assembler().written(
            task_sheet(title, named(order.point, order.student), given, order.items, meanings, drawn=form != "txt")
        )
    return formed(written, form, title)


def note_bytes(scene: Scene, order: Order) -> bytes:
    """The worked solution of a variant: its note."""
    titles = told_in(scene.spec.note.chapters if scene.spec.note is not None else ())
    note = note_of(scene.spec, scene.run, titles, scene.folder)
    return formed(note, Path(order.target).suffix[1:], scene.spec.project.title, frame_of_note(scene.spec))


def named(number: int, student: str) -> str:
    """Whose a paper is, in the language in force."""
    said = tr("Variant {number}", number=f"{number:02d}")
    return f"{said}. {tr('Student')}: {student}" if student else said


def traced(assignment: Path) -> tuple[Own, tuple[int, ...]]:
    """What of the task is drawn, found by one other number at a time; and the numbers that it does not tell.

    These are places of the assignments that make a variant.
    """
    variants = Variants(read_text(assignment), str(assignment), assignment.parent)
    spec = variants.spec()
    table = spec.class_
    assert table is not None
    keys = [key for each in table.drawn for key in each.of]
    drawn = drawn_of(spec, frame_of(assignment, (), keys, ()).axes)
    own, further, place = set[tuple[str, tuple[str, ...]]](), list[int](), 0
    base = _scene(variants, spec).run
    first: dict[Telling, Data] = {task_of: _data(task_of, spec, base), given_in: _data(given_in, base.spec, base)}
    for each, ends in zip(drawn, spans(drawn), strict=True):
        differing = _differing(variants, each, ends, base, first)
        own |= differing
        further += [] if differing else [place]
        place += len(each.axes)
    return frozenset(own), tuple(further)


def _differing(
    variants: Variants, drawn: Drawn, ends: Sequence[Fraction], base: RunResult, first: Mapping[Telling, Data]
) -> set[Mark]:
    """What differs of the task with another value of a number, by the spec alone; else of all that is given."""
    for of, known in first.items():
        for end in ends:
            changed = variants.spec([axis.assignment(float(end)) for axis in drawn.axes])
            try:
                done = base if of is task_of else run(changed)
                data = _data(of, changed if of is task_of else done.spec, done)
            except TmmError:
                continue
            if found := {mark for mark in {*data, *known} if data.get(mark) != known.get(mark)}:
                return found
    return set()


def _data(of: Telling, spec: Spec, found: RunResult) -> Data:
    with found.believed():
        blocks = of(spec, found.results)
    return {mark_of(block): row_of(block) for block in blocks if isinstance(block, Datum)}
