# SPDX-License-Identifier: BSD-3-Clause
"""Interval volumes, implicit flow fields and their volume rendering, for VTK in Python.

Each library has a module with its classes. This package imports all of them:

    from interlume import vtkIntervalVolume
    from interlume.InterlumeIntervals import vtkIntervalVolume

Constants are members of their class, or of the class of its settings, such as
vtkShadowedSliceSettings.BILINEAR_LOOKUP for vtkShadowedSliceMapper. report(algorithm) returns the values
of GetReport() as a dictionary.

The package requires the vtkmodules of the VTK version with which the libraries were built.
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

# An optional package, because TetGen has another license.
if find_spec(".InterlumeMeshing", __name__):
    from .InterlumeMeshing import *

from .report import report

del find_spec
