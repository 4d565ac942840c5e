"""A formula without what is nothing in a scene: terms and factors of names that are zero there, and what follows."""

from __future__ import annotations

from collections.abc import Container

from tmmcalc.report.formula.tree import Call, Name, Node, Number, Power, Product, Quotient, Statement, Sum, mapped

ZERO, ONE = Number("0"), Number("1")
AT_ZERO = {"sin": ZERO, "tan": ZERO, "asin": ZERO, "atan": ZERO, "sqrt": ZERO, "abs": ZERO, "rad": ZERO, "cos": ONE}


def simplified(found: Statement, zeros: Container[str]) -> Statement:
    """The statement where these names are zero; its left side stays.

    >>> from tmmcalc.report.formula.plain import plain
    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> plain(statement(simplified(read("U = (h + (y_G - y_P)*cos(g) - x_P*sin(g))/l"), {"h", "g"})))
    'U = (y_G − y_P)/l'
    """
    first, *others = found.sides
    return Statement((first, *(without(side, zeros) for side in others)), found.relations)


def without(node: Node, zeros: Container[str]) -> Node:
    """A node where these names are zero."""
    if isinstance(node, Name):
        return ZERO if node.key in zeros else node
    node = mapped(node, lambda part: without(part, zeros))
    match node:
        case Sum(terms):
            return _summed([(sign, term) for sign, term in terms if term != ZERO])
        case Product(factors):
            left = tuple(factor for factor in factors if factor != ONE)
            return ZERO if ZERO in factors else ONE if not left else left[0] if len(left) == 1 else _signed(left)
        case Quotient(over, under):
            return ZERO if over == ZERO else over if under == ONE else node
        case Power(Sum(((-1, inner),)), Number("2") as two):
            return Power(inner, two)
        case Power(base, _):
            return base if base in (ZERO, ONE) else node
        case Call(function, (argument,)) if argument == ZERO:
            return AT_ZERO.get(function, node)
        case Call("abs", (Sum(((_, term),)),)) | Call("sqrt", (Power(term, Number("2")),)):
            return Call("abs", (term,))
        case Call("atan2", (first, _)) if first == ZERO:
            return ZERO
    return node


def _signed(factors: tuple[Node, ...]) -> Node:
    """A product; the minus of what is left of a sum among its factors stands before the whole.

    >>> from tmmcalc.report.formula.plain import plain
    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> plain(statement(simplified(read("a = b + l*(e*c - w**2*s)"), {"b", "e"})))
    'a = −l w^2 s'
    """
    sign, bare = 1, list[Node]()
    for factor in factors:
        match factor:
            case Sum(((-1, Product(inner)),)):
                sign, bare = -sign, [*bare, *inner]
            case Sum(((-1, inner),)):
                sign, bare = -sign, [*bare, inner]
            case _:
                bare.append(factor)
    found = Product(tuple(bare))
    return found if sign > 0 else Sum(((-1, found),))


def _summed(terms: list[tuple[int, Node]]) -> Node:
    """The terms that are left, with those of a sum within that has no sign before it among them."""
    flat: list[tuple[int, Node]] = []
    for sign, term in terms:
        if isinstance(term, Sum) and len(term.terms) == 1:
            ((own, inner),) = term.terms
            flat.append((sign * own, inner))
            continue
        flat += term.terms if isinstance(term, Sum) and sign > 0 and not flat else [(sign, term)]
    if not flat:
        return ZERO
    return flat[0][1] if len(flat) == 1 and flat[0][0] > 0 else Sum(tuple(flat))
