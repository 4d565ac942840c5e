"""How good a pair is: contact ratios, flanks, sliding and pressure, verdicts, and why a pair cannot exist."""
