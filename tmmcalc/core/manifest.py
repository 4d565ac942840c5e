"""What a room says of itself: its tables, stages and commands. Nothing else in the house lists them.

A room is a package with a module ``room``, whose ``ROOM`` is a `Room`. What it names is found by the name:

    key of a spec   <room>.tables.<key>          the class in the annotation of the key
                    <room>.tables.checks.<key>   CHECKS
                    <room>.tables.words.<key>    what is said of its faults, see `tmmcalc.project.words`
                    <room>.tables.files          FORMS of the files in CSV that tables name, by the place
                    <room>.tables.names          functions that name elements without a name
    stage           <room>.stages.<name>         its functions, see `tmmcalc.core.stage.Stage`
    its facts       <room>.facts.<name>          summary(result, title)
    its picture     <room>.pictures.<name>       figure(order)
    its note        <room>.notes.<name>          blocks(order)
    what moves      <room>.views.<name>          views(order)
    what is given   <room>.notes.task            blocks(order)
    its studies     <room>.accuracy.<name>       studies(scene)
    command         cli.<name>, cli.<group>.<name>

A manifest imports no more than its own words.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple, Protocol, TypeVar

from tmmcalc.core.records import record
from tmmcalc.core.stage import Stage


@record
class Entry:
    """A table of the root of a spec; ``annotation`` is ``"MotorTable | None"``, or ``"list[LoadTable]"`` of several."""

    name: str
    module: str  # of its class, checks and words: its name, with a ``_`` behind a word of Python
    home: str  # package of the room, or of what belongs to none
    annotation: str
    description: str  # for editors
    subject: bool  # a spec may be about it alone
    describes: str  # what such a spec describes, where this is listed
    belongs_to: tuple[str, ...]  # tables, of which it needs one
    why: str  # it needs them
    read_with: tuple[str, ...]  # further tables that make sense of it
    checks: tuple[str, ...]  # modules of its checks beyond its values
    files: tuple[str, ...]  # keys in it that name a file; "file" is that of a table in CSV
    named: tuple[str, ...]  # function in <room>.tables.names that names its elements, and their keys that it takes
    after: str  # a table of another room that comes before it in the root
    gives: str  # the table that its stage finds, which it stands for until then; empty: none

    @property
    def several(self) -> bool:
        """Whether it is a list of tables."""
        return self.annotation.startswith("list[")

    @property
    def table(self) -> str:
        """Name of the class."""
        return self.annotation.removeprefix("list[").partition("]")[0].partition(" ")[0]

    @property
    def header(self) -> str:
        """The table as it stands in TOML."""
        return f"[[{self.name}]]" if self.several else f"[{self.name}]"


NO_CHAPTERS: Mapping[str, str] = {}
TABLES: dict[str, Entry] = {}  # those of all rooms, in the order of the root; `tmmcalc.rooms` enters them


class _Said(NamedTuple):
    """What the manifest says of a table beside its name and its class."""

    description: str
    subject: bool
    describes: str
    belongs_to: tuple[str, ...]
    why: str
    read_with: tuple[str, ...]
    checks: tuple[str, ...] | None
    files: tuple[str, ...]
    named: tuple[str, ...]
    after: str
    gives: str


def table(
    description: str,
    *,
    subject: bool = False,
    describes: str = "",
    belongs_to: tuple[str, ...] = (),
    why: str = "",
    read_with: tuple[str, ...] = (),
    checks: tuple[str, ...] | None = None,
    files: tuple[str, ...] = (),
    named: tuple[str, ...] = (),
    after: str = "",
    gives: str = "",
) -> Any:
    """Declare a table of the root of a spec, in a class of annotations that `Room` reads; see `Entry`.

    Its checks are by default those of one module of its name. A name that is a word of Python has a ``_`` behind it.
    """
    return _Said(description, subject, describes, belongs_to, why, read_with, checks, files, named, after, gives)


def entries(home: str, tables: type) -> tuple[Entry, ...]:
    """The tables that a class of annotations declares; ``home`` is the package that has them."""
    return tuple(_entries(home, tables))


def _entries(home: str, tables: type) -> Iterator[Entry]:
    for module, annotation in tables.__annotations__.items():
        said: _Said = getattr(tables, module)
        checks = (module,) if said.checks is None else said.checks
        yield Entry(module.removesuffix("_"), module, home, annotation, **said._replace(checks=checks)._asdict())


@record
class Command:
    """A command by its name, with its line in the help."""

    name: str
    help: str


@record
class Group:
    """The commands of a room that stand under a word of their own, such as ``tmmcalc gears``."""

    name: str
    help: str  # its line in the list of commands
    text: str  # what its own help says first
    example: str


class Room:
    """The manifest of a room; ``tables`` is a class whose annotations are declared by `table`."""

    def __init__(
        self,
        name: str,
        tables: type,
        stages: Sequence[Stage],
        commands: Sequence[Command] = (),
        *,
        section: str = "",
        group: Group | None = None,
        chapters: Mapping[str, str] = NO_CHAPTERS,
        gives: bool = False,
    ) -> None:
        self.name = name
        self.home = f"tmmcalc.{name}"
        self.tables = entries(self.home, tables)
        self.properties = {key: value for key, value in vars(tables).items() if isinstance(value, property)}
        self.stages = tuple(map(self._at_home, stages))
        self.commands = tuple(commands)
        self.section = section  # of the list of commands
        self.group = group
        self.chapters = chapters  # of the note: their titles by their names, in their order
        self.task = f"{self.home}.notes.task:blocks" if gives else ""  # what its scenes are given, for the note

    def _at_home(self, stage: Stage) -> Stage:
        """The stage with the places of its functions."""
        name = stage.name
        picture = stage.picture
        if picture is not None and not picture.figure:
            picture = replace(picture, figure=f"{self.home}.pictures.{name}:figure")
        return replace(
            stage,
            home=stage.home or f"{self.home}.stages.{name}",
            wanted=f"{self.home}.wanted:{stage.wanted}" if stage.wanted else "",
            reads=f"{self.home}.wanted:{stage.reads}" if stage.reads else "",
            facts=f"{self.home}.facts.{name}",
            picture=picture,
            note=f"{self.home}.notes.{name}" if stage.chapter else "",
            view=f"{self.home}.views.{name}" if stage.moves else "",
            studies=f"{self.home}.accuracy.{name}:studies" if stage.studied else "",
        )


class _Listed(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def after(self) -> str: ...


Item = TypeVar("Item", bound=_Listed)


def merged(rooms: Iterable[Sequence[Item]]) -> dict[str, Item]:
    """What the rooms list, in one order: each list keeps its own, and waits where an item comes ``after`` another.

    >>> class Named(NamedTuple):
    ...     name: str
    ...     after: str = ""
    >>> list(merged([[Named("a"), Named("b", "x")], [Named("x"), Named("y")]]))
    ['a', 'x', 'b', 'y']
    """
    waiting = [list(items) for items in rooms]
    found: dict[str, Item] = {}
    while any(waiting):
        ready = next((items for items in waiting if items and (not items[0].after or items[0].after in found)), None)
        if ready is None:
            raise ValueError(f"these come after what does not come: {[items[0].name for items in waiting if items]}")
        item = ready.pop(0)
        found[item.name] = item
    return found
