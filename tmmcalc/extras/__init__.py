"""Small calculators of neighbouring fields: elastic contact, reliability, tie-down, a falling ball, bearings."""
