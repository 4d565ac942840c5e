"""The formulas of the kinds of dyads for the note, a file a kind.

Each has ``POSITION``, ``VELOCITY``, ``ACCELERATION`` and ``REACTIONS``, formulas for general moving ports in the order
in which they are worked out, and ``quantities(at)``, the values of their names by the program beyond those of points
and links; ``MOMENTS`` says about which points those of the given forces are taken. In a formula ``<a>``, ``<b>`` are
the links, ``<P>``, ``<Q>`` the points of the outer joints, ``<B>`` that of the inner joint, ``<f>``, ``<g>`` the links
that they are joined to. What is zero in a scene is left out, and with it the terms of ports that stand still.
"""
