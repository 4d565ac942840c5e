"""Synthesis of cams: the sizes that keep the pressure angle, the curvature and the shaft within their limits.

``translating``, ``oscillating`` and ``flatface`` are the syntheses of the three followers, ``translatingsizes`` and
``oscillatingsizes`` what they are chosen from; ``halfplanes`` is a region bounded by a family of lines, ``bestplace``
its best point by one of the ``objectives``, ``curves`` the same where one size is prescribed, ``polygon`` its corners,
``roller`` the roller, ``enlargement`` a larger cam where the pressure angle is not what decides, ``pivotclearance`` one
that passes its rocker's pivot; ``completion`` judges what was found, ``solve`` puts them together.
"""
