from tmmcalc.report.drawing.order import Order
def blocks(order): return iter(())
