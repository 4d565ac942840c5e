"""Pictures of gear trains: the scheme to scale, tooth sets, what constraints removed, curves of choice, Pareto front,
blocking contours.

placed (a train to scale) -> endview, lengthwise -> sideview -> scheme (sheet)
cloud -> solutions, graphs, front (diagrams); with the scheme -> train, criteria (drawings of the stages)
placedpair (a pair to scale) -> sketch -> dimensions -> mesh; slidingcurves, listing -> pairtable -> pair (of the stage)
generation -> toothdrawing -> profile, wheel (of the stages)
contourpaths -> contourlines, contourlook -> contournumbers -> contourplane, contourkey -> blocking (of the stage)
"""
