// SPDX-License-Identifier: BSD-3-Clause
// A protein, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Protein.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolumeProperty.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::MakeProtein(), { 0.0, 0.0, 0.52 }, 90.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.7, 0.04, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.73, 0.73, -0.73, 0.73, -0.08, 1.05), 170, 0.7);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85));
  pair.Look({ 0.0, -1.0, 0.55 }, vtkBoundingBox(-0.69, 0.69, -0.1, 0.1, -0.3, 1.02));
}

const gallery::SceneRegistration registration(
  { "protein", "2.10", "A protein, without and with shadows",
    "The absolute value of an electron's wave function in a high-potential iron protein, as the "
    "lumps where it is large. The shadows tell which lump is in front of which, and how high each "
    "is above the disk.",
    { "ironProt.vtk" }, &Build });
}
