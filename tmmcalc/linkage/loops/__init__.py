"""Assur groups of any class by the closure of their loops: equations, branches, assemblies."""
