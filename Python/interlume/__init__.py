# SPDX-License-Identifier: BSD-3-Clause
"""Interval volumes, implicit flow fields and their drawing as volumes, for VTK's Python.

The classes stand in modules that are named as the libraries, and all of them here as well:

    from interlume import vtkIntervalVolume
    from interlume.InterlumeIntervals import vtkIntervalVolume

Constants of a class stand in it, or in its settings, as vtkShadowedSliceSettings.BILINEAR_LIGHT for
vtkShadowedSliceMapper. report(algorithm) returns the values of GetReport() as a dictionary.

They work with the vtkmodules of the VTK that the libraries were built with, and with no other.
"""

from importlib.util import find_spec

from .InterlumeCommon import *
from .InterlumeIsotables import *
from .InterlumeIntervals import *
from .InterlumeFlow import *
from .InterlumeSources import *
from .InterlumeTetrahedra import *
from .InterlumeLight import *
from .InterlumeFlowTexture import *

# TetGen's licence is another, so what uses it may not be installed.
if find_spec(".InterlumeMeshing", __name__):
    from .InterlumeMeshing import *

from .report import report

del find_spec
