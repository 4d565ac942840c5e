"""Texts in XML.

`xml.sax.saxutils` says the same, and with it come the clients of the network: a tenth of a short command.
"""

from __future__ import annotations


def escape(text: str) -> str:
    """A text between tags.

    >>> escape("a < b & c")
    'a &lt; b &amp; c'
    """
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def quoteattr(text: str) -> str:
    r"""The value of an attribute, with the quotes around it.

    >>> quoteattr('3" bolt')
    '"3&quot; bolt"'
    """
    said = escape(text).replace('"', "&quot;")
    return f'"{said.replace(chr(10), "&#10;").replace(chr(13), "&#13;").replace(chr(9), "&#9;")}"'
