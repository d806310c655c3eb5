# SPDX-License-Identifier: BSD-3-Clause
"""An icosahedron filled with tetrahedra of bounded shape and volume, cut open and pulled apart."""

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from interlume import vtkTetrahedralMesher
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkShrinkFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkDataSetMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor)

solid = vtkPlatonicSolidSource()
solid.SetSolidTypeToIcosahedron()
mesher = vtkTetrahedralMesher()
mesher.SetInputConnection(solid.GetOutputPort())
mesher.SetQualityBound(1.4)
mesher.SetMaximumVolume(0.004)
plane = vtkPlane()
plane.SetNormal(0, -1, 0)
half = vtkExtractGeometry()
half.SetInputConnection(mesher.GetOutputPort())
half.SetImplicitFunction(plane)
apart = vtkShrinkFilter()
apart.SetInputConnection(half.GetOutputPort())
apart.SetShrinkFactor(0.85)
mapper = vtkDataSetMapper()
mapper.SetInputConnection(apart.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.95, 0.72, 0.35)
actor.GetProperty().SetInterpolationToFlat()
actor.GetProperty().SetAmbient(0.15)

renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.13, 0.15, 0.19)
camera = renderer.GetActiveCamera()
camera.SetPosition(0.8, -1, 0.5)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera()
camera.Zoom(1.4)
window = vtkRenderWindow()
window.SetSize(900, 600)
window.SetWindowName("Meshing")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Start()
