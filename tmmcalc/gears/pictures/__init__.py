"""Pictures of gear trains: the scheme to scale, tooth sets, what constraints removed, curves of choice, Pareto front,
blocking contours.

placed (a train to scale) -> endview, lengthwise -> sideview -> scheme (sheet)
solutions, graphs, front (sheets) -> train, criteria (figures of the stages)
placedpair (a pair to scale) -> sketch -> dimensions -> mesh; slidingcurves, listing -> pairtable -> pairsheet (of pair)
generation -> toothdrawing -> toothpicture (figure of the stage profile)
contourpaths -> contourlines, contourlook -> contournumbers -> contourplane, contourkey -> contour (figure of blocking)
"""
