"""Write the laws of motion into the table of docs/spec.md: ``make docs``."""

from pathlib import Path

from tmmcalc.cams.laws.catalogue import NAMES, title_of

PAGE = Path(__file__).parent / "spec.md"
HEAD, OWN = "| `law` | |\n|---|---|\n", "| `{ points ="  # what stands before the laws by name, and after them


def rows() -> str:
    """A row a law of the catalogue."""
    return "".join(f'| `"{name}"` | {title_of(name)} |\n' for name in NAMES)


def written(page: str) -> str:
    """The page with these rows."""
    before, _, rest = page.partition(HEAD)
    return f"{before}{HEAD}{rows()}{rest[rest.index(OWN) :]}"


if __name__ == "__main__":
    PAGE.write_text(written(PAGE.read_text()))
