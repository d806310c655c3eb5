# SPDX-License-Identifier: BSD-3-Clause
"""Tests the Python package: an interval volume of a wavelet and, if its package is installed, a mesh of a
sphere by TetGen."""

import sys

import interlume
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

wavelet = vtkRTAnalyticSource()
volume = interlume.vtkIntervalVolume()
volume.SetInputConnection(wavelet.GetOutputPort())
volume.SetInterval(0, 140.0, 180.0)
volume.Update()
cells = volume.GetOutput().GetNumberOfCells()
print(cells, "tetrahedra in Python")
if cells == 0:
    sys.exit(1)
if "--tetgen" in sys.argv:
    sphere = vtkSphereSource()
    mesher = interlume.vtkTetrahedralMesher()
    mesher.SetInputConnection(sphere.GetOutputPort())
    mesher.Update()
    cells = mesher.GetOutput().GetNumberOfCells()
    print(cells, "tetrahedra of a sphere")
    sys.exit(cells == 0)
elif hasattr(interlume, "vtkTetrahedralMesher"):
    sys.exit("vtkTetrahedralMesher exists, although its package is not installed")
