"""A Makefile rule that names the files of a run and what they depend on, for ``include`` in a Makefile.

    out/kinematics.toml: shaper.toml

    shaper.toml:

The empty rules keep make going when a source has been renamed or removed (as ``gcc -MP`` does).
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from tmmcalc.core.atomic import replace_file
from tmmcalc.core.errors import UsageError

_UNSPEAKABLE = "\n\r;|%"  # make has no quoting for these in a rule


def write(path: Path, targets: Iterable[Path | str], sources: Iterable[Path | str]) -> None:
    """Write to ``path`` the rule that makes ``targets`` depend on ``sources``.

    Raises UsageError if a name cannot stand in a Makefile, or if the file cannot be written.
    """
    names = [escaped(str(source)) for source in sources]
    rule = f"{' '.join(escaped(str(target)) for target in targets)}: {' '.join(names)}\n"
    phony = "".join(f"\n{name}:\n" for name in names)
    replace_file(Path(path), (rule + phony).encode())


def escaped(name: str) -> str:
    r"""Return a file name as GNU make reads it in a rule.

    >>> escaped("my project#2.toml")
    'my\\ project\\#2.toml'
    """
    bad = next((sign for sign in name if sign in _UNSPEAKABLE), None)
    if bad is not None:
        raise UsageError(f"{name!r}: a Makefile rule cannot hold {bad!r}", remedy="rename the file or omit --depfile")
    text = f"./{name}" if name.startswith("~") else name
    return "".join(_sign(text, at) for at in range(len(text)))


def _sign(text: str, at: int) -> str:
    """Return one character as make reads it; '=' hides in a function, or the rule would be an assignment."""
    sign = text[at]
    if sign == "\\":
        rest = text[at:].lstrip("\\")
        return "\\\\" if rest[:1] and rest[0] in " \t#:*?[" else "\\"
    return {"$": "$$", "=": "$(or =)"}.get(sign, f"\\{sign}" if sign in " \t#:*?[" else sign)
