"""What a page shows moving of linkages (`tmmcalc.report.moving`)."""
