"""Pictures of gear trains: the scheme to scale, tooth sets, what constraints removed, curves of choice, Pareto front.

placed (a train to scale) -> endview, lengthwise -> sideview -> scheme (sheet)
solutions, graphs, front (sheets) -> train, criteria (figures of the stages)
"""
