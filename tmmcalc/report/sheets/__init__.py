"""Sheets that are handed in: pictures of several stages on large paper, with a frame and a title block.

A stage gives `Piece`s, which say what they need and draw themselves in the room that the layout finds for them.
"""
