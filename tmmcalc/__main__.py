"""``python -m tmmcalc``."""

from tmmcalc.cli import main

main()
