"""Kinetostatics: reactions in all pairs and the drive, group by group, without and with friction.

    loads of a group + reactions of the groups that hang on it  ->  its reactions  ->  ...  ->  the input link

Every dyad is statically determinate (textbook 3.2): the force that its inner joint transmits has two unknown
components, and each outer joint gives one equation. The same two equations serve all five kinds.
"""
