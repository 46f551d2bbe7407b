"""The symbolic engine: it runs plain Python on symbolic reals, one feasible path after another, under Z3.

It knows nothing of bodies.
"""
