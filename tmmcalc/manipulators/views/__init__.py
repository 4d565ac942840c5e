"""What a page shows moving of manipulators (`tmmcalc.report.moving`)."""
