"""What a page shows moving of vibrations (`tmmcalc.report.moving`)."""
