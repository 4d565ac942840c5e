"""What a page shows moving of gears (`tmmcalc.report.moving`)."""
