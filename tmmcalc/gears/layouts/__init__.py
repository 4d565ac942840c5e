"""The layouts of gear trains, a file each, or one for those whose teeth obey the same.

A file has its `Layout`, with all that is its own: wheels, meshes, what its teeth obey, candidates, how it is built and
drawn. A new one joins by its place in LAYOUTS. The checks of a spec read layouts, so numpy and the search for teeth are
imported in the functions that compute.
"""

from tmmcalc.gears.layouts.common_axis import AA, AI, COAXIAL, II
from tmmcalc.gears.layouts.open_pair import OPEN, OPEN_RING
from tmmcalc.gears.layouts.paired_planets import PAIRED
from tmmcalc.gears.layouts.single_planets import AIBAR
from tmmcalc.gears.layouts.three_centrals import AII
from tmmcalc.gears.layouts.unfolded import THREE, TWO

LAYOUTS = {each.key: each for each in (TWO, THREE, COAXIAL, AIBAR, AI, AA, II, AII, PAIRED)}
PARTS = {each.key: each for each in (OPEN, OPEN_RING)}  # of a drive, beside its train
