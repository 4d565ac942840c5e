def blocks(order): return []
