"""The language of results: names, and what they stand for in the results of stages."""
