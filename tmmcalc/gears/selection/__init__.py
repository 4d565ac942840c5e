"""The best of all trains that are strong enough: criteria of every variant, front, ranking, comparisons, winner."""
