"""Papers of a whole class: each variant is run once and its papers are written, in processes side by side."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.batch.choice import local
from tmmcalc.batch.local import available, cores
from tmmcalc.batch.task import Row, Task, verdict
from tmmcalc.classroom.model import Item
from tmmcalc.classroom.papers.tasksheet import Own, given_of, mark_of, meanings_of, task_sheet
from tmmcalc.core.atomic import blamed_on, replace_file
from tmmcalc.core.errors import NoSolutionError, TmmError
from tmmcalc.core.stage import resolve
from tmmcalc.naming.language import parse
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.forms import formed
from tmmcalc.note.made import frame_of, note_of, told_in
from tmmcalc.pipeline.chapters import task_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.report.language import speaking, tr
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.printing import printing
from tmmcalc.spec.override import split

if TYPE_CHECKING:
    from tmmcalc.classroom.state import Class, Variant
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

SOLVER = "tmmcalc.classroom.papers.making:solve_papers"
FEW = 4  # papers that are not worth a process


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
                raise NoSolutionError(row.reason, where=f"variant {row.point}", remedy="draw this variant again")
        done += len(rows)
        told(done)


def _row(variants: Variants, order: Order) -> Row:
    try:
        spec = variants.spec(order.assignments)
        make: Callable[[Scene, Order], bytes] = resolve(order.maker)
        units = spec.note.units if spec.note is not None else ()
        with speaking(order.language), printing(units):
            replace_file(Path(order.target), make(_scene(variants, spec, order.items), order))
    except Exception as error:  # one variant that breaks the program must not end the others
        return Row(order.point, *verdict(error))
    return Row(order.point, *verdict(None))


def _scene(variants: Variants, spec: Spec, items: Iterable[Item]) -> Scene:
    stages = tuple(dict.fromkeys(parse(item.result).stage for item in items))
    return Scene(spec, run(spec, target=stages or None), variants.folder)


def sheet_bytes(scene: Scene, order: Order) -> bytes:
    """The task sheet of a variant in the form of its file."""
    values = dict(split(each) for each in (order.assignments[at] for at in order.further))
    with scene.run.believed():
        blocks = task_of(scene.run.spec, scene.run.results)
        given = given_of(blocks, order.own, {key: value.strip('"') for key, value in values.items()})
        meanings = meanings_of(order.items, scene.run)
        title = scene.spec.project.title
        written = Assembler().written(task_sheet(title, named(order.point, order.student), given, order.items, meanings))
    return formed(written, Path(order.target).suffix[1:], title)


def note_bytes(scene: Scene, order: Order) -> bytes:
    """The worked solution of a variant: its note."""
    titles = told_in(scene.spec.note.chapters if scene.spec.note is not None else ())
    whole = scene._replace(run=run(scene.spec))
    note = note_of(whole.spec, whole.run, titles, whole.folder)
    return formed(note, Path(order.target).suffix[1:], scene.spec.project.title, frame_of(scene.spec))


def named(number: int, student: str) -> str:
    """Whose a paper is, in the language in force."""
    said = tr("Variant {number}", number=f"{number:02d}")
    return f"{said}. {tr('Student')}: {student}" if student else said


def traced(assignment: Path, made: Class, items: Sequence[Item], language: str) -> tuple[Own, tuple[int, ...]]:
    """What of the task is drawn, found by a change of one drawn number at a time; and the numbers that it does not tell.

    What other numbers of the class are is taken for the change; one that is the same in all variants is nobody's own.
    """
    variants = Variants(read_text(assignment), str(assignment), assignment.parent)
    own, further = set[tuple[str, tuple[str, ...]]](), list[int]()
    with speaking(language):
        spec = variants.spec()
        base = _scene(variants, spec, items)
        first = _data(base, base.run)
        for at, others in enumerate(zip(*(each.assignments for each in made.variants), strict=True)):
            changes = [data for each in dict.fromkeys(others) if (data := _changed(variants, each, base, items)) != first]
            differing = {key for data in changes[:1] for key in {*data, *first} if data.get(key) != first.get(key)}
            own |= differing
            if not differing:
                further.append(at)
    return frozenset(own), tuple(further)


def _changed(variants: Variants, assignment: str, base: Scene, items: Sequence[Item]) -> dict[object, Datum]:
    """The task with one other number; where that has no solution, what the results of the base let it tell."""
    spec = variants.spec((assignment,))
    try:
        scene = _scene(variants, spec, items)
    except TmmError:
        scene = base._replace(spec=spec)
    return _data(scene, scene.run)


def _data(scene: Scene, found: RunResult) -> Mapping[object, Datum]:
    return {}
