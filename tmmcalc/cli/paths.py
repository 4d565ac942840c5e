"""``tmmcalc paths``."""

from __future__ import annotations

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "paths",
    """Paths: how far the path of a point is from a wanted one, a row a wanted point.

    Without a timing the place of the path nearest to each point counts.

    Example: tmmcalc paths my.toml --set 'mechanism.links[id=2].points.P[0]="25 mm"'
    """,
    heading="wanted paths",
)
