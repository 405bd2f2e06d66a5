"""The exact motion of rigid bodies on slack cables.

    import numpy as np, tautline as tl

    motion = tl.solve(tl.Case.shipped("bouncing-ball"))
    motion.impacts.time                  # [s]
    motion(np.linspace(0, 2, 100))[:, 1]  # height [m]

Units are in brackets. Lengths, masses and times may also be without units: the gravity of a case decides.
"""
from ._case import Cable, Case, State, shipped_cases
from ._draws import Draws, draws
from ._library import C as _C
from ._library import ENDINGS, KINDS, LAWS
from ._motion import (Accumulations, Arcs, EventErrors, Events, Motion, Repetition, Settling, Swing, Unsure, solve)
from ._sweep import sweep

__version__: str = _C["version"]().decode()

__all__ = ["Accumulations", "Arcs", "Cable", "Case", "Draws", "ENDINGS", "EventErrors", "Events", "KINDS", "LAWS",
           "Motion", "Repetition", "Settling", "State", "Swing", "Unsure", "draws", "shipped_cases", "solve", "sweep"]
