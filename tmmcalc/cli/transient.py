"""``tmmcalc transient``."""

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Columns, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("transient")
def command(solved: Solved, columns: Columns = None) -> Document:
    """Transient: start-up, braking, run-down and load changes in time, of one mass or of an elastic drive.

    The table shows some rows of every motion; --format csv prints all of them.

    Example: tmmcalc transient my.toml --columns 't,omega*,M_*'
    """
    return solved.document(patterns=patterns_of(columns), everything=solved.everything, where=solved.where)
