"""Texts that a person wrote for the note: files of Markdown in a folder beside the spec, each with its place.

``task.md``, ``introduction.md``, ``conclusions.md``, ``literature.md``, ``appendix.md`` are parts of their own;
``kinematics.md`` and its like stand at the end of the chapters of these names. A formula stands within ``$``; the
numbers of tables, figures and formulas in ``{tab:links}`` and its like, by their keys.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.lettering import pieces, plain
from tmmcalc.report.formula.syntax import FormulaError, read
from tmmcalc.report.manuscript import Block, Heading, Listing, Paragraph, Table, Verbatim

if TYPE_CHECKING:
    from markdown_it.tree import SyntaxTreeNode

PARTS = ("task", "introduction", "conclusions", "literature", "appendix")
DEEPEST = 3  # level of a heading


def own_texts(folder: Path, chapters: Collection[str]) -> dict[str, tuple[Block, ...]]:
    """The texts in a folder by their parts and chapters; none of a folder that is not there.

    Raises `UsageError` with all that is wrong in them: a name that is no part, what a note does not have, a formula
    that is none.
    """
    known = [*PARTS, *chapters]
    found: dict[str, tuple[Block, ...]] = {}
    faults: list[UsageError] = []
    for file in sorted(folder.glob("*.md")):
        if file.stem not in known:
            remedy = f"there are: {', '.join(known)}"
            faults.append(UsageError(f"no part of a note is called {file.stem!r}", where=str(file), remedy=remedy))
            continue
        try:
            found[file.stem] = tuple(_blocks(_tree(file), file))
        except UsageError as fault:
            faults.append(fault)
    if faults:
        raise UsageError("\n".join(map(str, faults)))
    return found


def _tree(file: Path) -> SyntaxTreeNode:
    from markdown_it import MarkdownIt  # which rich brings along
    from markdown_it.tree import SyntaxTreeNode

    try:
        text = file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"it cannot be read: {error}", where=str(file), remedy="save it as UTF-8") from None
    return SyntaxTreeNode(MarkdownIt("commonmark").enable("table").parse(text))


def _blocks(tree: SyntaxTreeNode, file: Path) -> Iterator[Block]:
    for node in tree.children:
        match node.type:
            case "heading":
                yield Heading(_words(node, file), min(int(node.tag[1:]) + 1, DEEPEST))
            case "paragraph":
                yield Paragraph(_words(node, file))
            case "bullet_list" | "ordered_list":
                yield Listing(tuple(_words(item, file) for item in node.children))
            case "fence" | "code_block":
                yield Verbatim(node.content.rstrip("\n"))
            case "table":
                head, *rows = [
                    tuple(_words(cell, file) for cell in row.children)
                    for part in node.children
                    for row in part.children
                ]
                yield Table("", head, tuple(rows))
            case _:
                raise _fault(node, file, f"a note has no {node.type.replace('_', ' ')}")


def _words(node: SyntaxTreeNode, file: Path) -> str:
    """The text of a node, emphasis left out; every formula in it is one, and every letter is there."""
    found = "".join(_said(part, file) for part in node.walk() if not part.children).strip()
    try:
        for k, piece in enumerate(found.split("$")):
            if k % 2:
                read(piece)
            else:
                pieces(plain(piece))
    except FormulaError as error:
        raise _fault(node, file, f"a formula that is none: {error}") from None
    except UsageError as error:
        raise _fault(node, file, error.message) from None
    if found.count("$") % 2:
        raise _fault(node, file, "a formula has no end: an odd number of $")
    return found


def _said(part: SyntaxTreeNode, file: Path) -> str:
    match part.type:
        case "text" | "code_inline" | "text_special":
            return part.content
        case "softbreak" | "hardbreak":
            return " "
        case "image" | "html_inline":
            raise _fault(part, file, f"a note has no {part.type.replace('_', ' ')}")
    return ""


def _fault(node: SyntaxTreeNode, file: Path, message: str) -> UsageError:
    at: SyntaxTreeNode | None = node
    while at is not None and at.map is None:
        at = at.parent
    line = f":{at.map[0] + 1}" if at is not None and at.map else ""
    return UsageError(message, where=f"{file}{line}", remedy="write headings, paragraphs, lists, tables, $formulas$")
