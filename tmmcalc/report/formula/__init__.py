"""Formulas of notes: written once as a text, from which letters, numbers and the value come.

`syntax` reads a text to a `tree`, which is evaluated with numbers by name; `digits` finds how many of them a printed
line needs to work out; `setting` makes of the tree what is typeset, in letters or in numbers, which `typst`, `mathml`,
`omml` and `plain` write.
"""
