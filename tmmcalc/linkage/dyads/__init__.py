"""The five dyads, one file a kind. What a kind provides is listed in `base`."""

from tmmcalc.linkage.dyads.base import Dyad
from tmmcalc.linkage.dyads.prp import PRP
from tmmcalc.linkage.dyads.rpp import RPP
from tmmcalc.linkage.dyads.rpr import RPR
from tmmcalc.linkage.dyads.rrp import RRP
from tmmcalc.linkage.dyads.rrr import RRR

__all__ = ["PRP", "RPP", "RPR", "RRP", "RRR", "Dyad"]

KINDS: dict[str, type[Dyad]] = {kind.__name__: kind for kind in (RRR, RRP, RPR, PRP, RPP)}
ONE_ASSEMBLY = tuple(name for name, kind in KINDS.items() if "variant" not in kind.__annotations__)
