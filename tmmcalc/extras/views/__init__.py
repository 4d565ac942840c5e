"""What a page shows moving of the small calculators (`tmmcalc.report.moving`)."""
