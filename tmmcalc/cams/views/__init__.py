"""What a page shows moving of cams (`tmmcalc.report.moving`)."""
