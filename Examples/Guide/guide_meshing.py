# SPDX-License-Identifier: BSD-3-Clause
"""An icosahedron filled with tetrahedra of bounded shape and volume, cut open."""

from guide_image import GuideImage
from interlume import vtkTetrahedralMesher
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper

picture = GuideImage()

surface = vtkPlatonicSolidSource()
surface.SetSolidTypeToIcosahedron()
mesher = vtkTetrahedralMesher()
mesher.SetInputConnection(surface.GetOutputPort())
mesher.SetQualityBound(1.4)
mesher.SetMaximumVolume(0.002)
plane = vtkPlane()
plane.SetNormal(0.0, -1.0, 0.0)
half = vtkExtractGeometry()
half.SetInputConnection(mesher.GetOutputPort())
half.SetImplicitFunction(plane)
mapper = vtkDataSetMapper()
mapper.SetInputConnection(half.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.56, 0.76, 0.72)
actor.GetProperty().EdgeVisibilityOn()
picture.renderer.AddActor(actor)

picture.write(0.4, -1.5, 0.5)
