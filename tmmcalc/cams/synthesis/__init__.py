"""Synthesis of cams: the sizes that keep the pressure angle, the curvature and the shaft within their limits.

``translating``, ``oscillating`` and ``flat`` find the sizes of the three followers; ``halfplanes`` is a region bounded
by a family of lines, ``exchange`` its best point by one of ``aims``, ``curves`` the same where one size is prescribed,
``region`` its corners, ``roller`` the roller, ``growth`` a larger cam where the pressure angle is not what decides;
``stem``, ``rocker`` and ``solve`` put them together, ``finish`` judges what was found.
"""
