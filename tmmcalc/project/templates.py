"""The ready specs that come with the program: the package's own ``configs``, or those of the checkout."""

from __future__ import annotations

from pathlib import Path

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.phrases import did_you_mean, listing

_PACKAGE = Path(__file__).resolve().parent.parent
_DIRECTIVE = "#:schema "  # of the editors: what follows, a path from the spec or a URL, describes the spec
_SCHEMA = "tmmcalc.schema.json"  # among the ready specs


def folder() -> Path:
    """Return the folder of the ready specs; raise UsageError if the installation has none."""
    for parent in (_PACKAGE, _PACKAGE.parent):
        if (parent / "configs").is_dir():
            return parent / "configs"
    raise UsageError("this installation has no ready specs", remedy="install tmmcalc again from its wheel")


def names() -> list[str]:
    """Return the names of the ready specs, sorted; those of a subfolder as ``extreme/name``."""
    home = folder()
    return sorted(file.relative_to(home).with_suffix("").as_posix() for file in home.rglob("*.toml"))


def path(name: str) -> Path:
    """Return the file of a ready spec; raise UsageError if there is none of this name."""
    known = names()
    if name not in known:
        guess = did_you_mean(name, known)
        raise UsageError(f"there is no ready spec '{name}'", remedy=f"{guess} there are: {listing(known)}".strip())
    return folder() / f"{name}.toml"


def text(name: str) -> str:
    """Return the text of a ready spec; its first line names the schema of this installation, wherever it will stand.

    >>> text("extreme/slip").splitlines()[1]
    '# Extreme: a motor whose rated slip is one hundred-thousandth: the speed hardly knows of the load.'
    """
    whole = path(name).read_text(encoding="utf-8")
    if not whole.startswith(_DIRECTIVE):
        return whole
    return f"{_DIRECTIVE}{(folder() / _SCHEMA).as_uri()}\n{whole.partition(chr(10))[2]}"


def beside(name: str) -> list[Path]:
    """Return the files that a ready spec names, such as its CSV tables; their paths count from the spec.

    >>> [file.name for file in beside("cam-own-law")]
    ['cam-law.csv']
    """
    from tmmcalc.project.files import named_files  # late: only what is written needs it
    from tmmcalc.project.loader import load_spec

    home = path(name)
    return named_files(load_spec(home), home.parent)


def description(name: str) -> str:
    """Return the description of a ready spec: its first comment up to the line that ends a sentence."""
    told: list[str] = []
    for line in text(name).splitlines():
        if line.startswith(_DIRECTIVE):
            continue
        said = line.removeprefix("#").strip()
        if not line.startswith("#") or not said:
            if said or told:
                break
            continue
        told.append(said)
        if said.endswith((".", "?")):
            break
    return " ".join(told)
