"""The formulas of the kinds of dyads for the note, a file a kind.

Each has ``POSITION``, ``VELOCITY`` and ``ACCELERATION``, formulas for general moving ports in the order in which they are
worked out, and ``quantities(at)``, the values of their names by the program beyond those of points and links. In a
formula ``<a>``, ``<b>`` are the links, ``<P>``, ``<Q>`` the points of the outer joints, ``<B>`` that of the inner joint; what is
zero in a scene is left out of them, and with it the terms of ports that stand still.
"""
