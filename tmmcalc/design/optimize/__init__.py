"""The best design: variables, results that are to be least or greatest, constraints; search, polish, proof."""
