"""The commands by name: their module and their one line of help, known before any body is imported."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.manifest import Command, Group
from tmmcalc.rooms import ROOMS

Table = dict[str, tuple[str, str]]  # module and one line of help, by the command's name


CLASS = Group(
    "class",
    "Classes: variants of one assignment.",
    "Classes: an assignment for many, a variant for each student.",
    "tmmcalc class make assignment.toml -n 40 --seed 7 -o class",
)
OF_CLASS = (
    Command("make", "Draw variants of an assignment, each with numbers of its own."),
    Command("keys", "What is right of each variant, and what comes out with known mistakes."),
    Command("mark", "Mark what students hand in, and say why answers are wrong."),
    Command("hints", "For a student: which of the own answers are right, with hints."),
)


def _table(commands: tuple[Command, ...], group: str = "") -> Table:
    home = f"tmmcalc.cli.{group}." if group else "tmmcalc.cli."
    return {each.name: (home + each.name.replace("-", "_"), each.help) for each in commands}


def _section(name: str) -> Table:
    """The commands that rooms put under a heading."""
    return {key: line for room in ROOMS if room.section == name for key, line in _table(room.commands).items()}


def _groups() -> Table:
    return {
        room.group.name: (f"tmmcalc.cli.{room.group.name}", room.group.help) for room in ROOMS if room.group is not None
    }


SECTIONS = {
    "Specs": _table(
        (
            Command("init", "Write a commented starter spec."),
            Command("check", "Check specs and report all their faults."),
            Command("schema", "Print the JSON Schema of a spec, for TOML editors."),
            Command("plan", "Show which stages run for a spec, which do not, and why."),
        )
    ),
    "Linkages": _section("Linkages"),
    "Machines": _section("Machines"),
    "Gears, cams and others": _groups(),
    "All stages": _table(
        (
            Command("run", "Run every stage that the spec has."),
            Command("names", "What a scene can tell, by name: symbol, unit, meaning, value."),
            Command("sweep", "Variants of a spec over ranges of its keys, to one CSV."),
            Command("sensitivity", "Which numbers of a spec matter for a result, by how much."),
            Command("optimize", "The best design: variables, objectives, constraints."),
            Command("feasibility", "Constraints on results: which hold, by how much."),
            Command("tolerance", "What tolerances do: worst case, statistics, yield, shares."),
            Command("plot", "Draw the result of a stage to an svg, png, pdf or dxf file."),
            Command("sheet", "Draw the sheets that are handed in: A1, with frame and title block."),
            Command("note", "The explanatory note: every formula in letters, in numbers, checked."),
            Command("page", "One HTML file in which the machine moves, with diagrams and all results."),
            Command("accuracy", "Error against run time of every method of the stages."),
            Command("stress", "Ladders of extremes: where every stage loses its digits."),
        )
    ),
    "Teaching": {CLASS.name: ("tmmcalc.cli.classroom", CLASS.help)},
}

COMMANDS = {name: line for section in SECTIONS.values() for name, line in section.items()}


def computes(words: Sequence[str]) -> bool:
    """Whether the words of a command line ask for numbers: not for help, nor for something of a spec alone."""
    asked = len(words) > 1 and not {"-h", "--help"} & set(words)
    return asked and words[0] in COMMANDS and words[0] not in SECTIONS["Specs"]


def group_of(name: str) -> Group:
    """What stands under this word: commands of a room, or of the class."""
    rooms = (room.group for room in ROOMS if room.group is not None)
    return next(group for group in (*rooms, CLASS) if group.name == name)


def grouped(name: str) -> Table:
    """The commands that stand under a word of their own."""
    if name == CLASS.name:
        return _table(OF_CLASS, "classroom")
    room = next(room for room in ROOMS if room.group is not None and room.group.name == name)
    return _table(room.commands, name)
