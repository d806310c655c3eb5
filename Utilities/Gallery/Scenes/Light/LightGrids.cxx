// SPDX-License-Identifier: BSD-3-Clause
// Grids of parallel light that show the shape of surfaces.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/Protein.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"

namespace
{
void BuildSphere(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::Sample(
    gallery::Unite({ gallery::Place(gallery::SoftenEdges(vtkConstructiveModelSource::MakeModel(
                                      vtkConstructiveModelSource::TWO_SPHERES)),
                       { -0.15, 0.0, 0.0 }),
      gallery::MakeDisk({ 0.1, 0.05, -0.5 }, 1.1, 0.06, gallery::PlasterColor()) }),
    vtkBoundingBox(-1.05, 1.25, -1.1, 1.2, -0.6, 0.83), 200);
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    { gallery::MakeParallelProjector(
        { -2.4, -2.2, 3.4 }, { 0.0, 0.0, 0.0 }, 3.2, 3.2, 1.9, gallery::MakeGridPattern(32, 0.14)),
      gallery::MakeFillLight({ 1.0, -1.0, 0.4 }, 0.25) });
  panel.SetBackground({ 0.66, 0.72, 0.78 }, { 0.18, 0.22, 0.30 });
  panel.Frame(vtkBoundingBox(-1.0, 1.2, -0.3, 0.3, -1.05, 0.76));
  panel.LookFrom({ 0.2, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

void BuildProtein(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::MakeProtein(), { 0.0, 0.0, 0.55 }, 90.0),
      gallery::MakeDisk({ 0.14, 0.14, 0.0 }, 0.92, 0.05, gallery::PlasterColor()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.82, 1.1, -0.82, 1.1, -0.08, 1.1), 232);
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    { gallery::MakeParallelProjector(
        { -1.6, -2.4, 2.4 }, { 0.0, 0.0, 0.3 }, 2.4, 2.4, 2.3, gallery::MakeGridPattern(40, 0.14)),
      gallery::MakeFillLight({ 1.0, -1.0, 0.4 }, 0.25) });
  panel.SetBackground({ 0.66, 0.72, 0.78 }, { 0.18, 0.22, 0.30 });
  panel.Frame(vtkBoundingBox(-0.74, 0.98, -0.2, 0.2, -0.36, 1.03));
  panel.LookFrom({ 0.25, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration sphere(
  { "light-grid-sphere", "2.20", "A grid of light on two spheres",
    "A parallel light shines through a screen with a grid on a union of two spheres. Perpendicular "
    "to the light all grid cells have the same size, so they measure the spheres and show their "
    "slope.",
    {}, &BuildSphere });
const gallery::SceneRegistration protein(
  { "light-grid-protein", "2.21", "A grid of light on a protein",
    "The absolute value of an electron's wave function in a high-potential iron protein, as blobs "
    "around its maxima. A parallel light shines through a screen with a grid. The grid cells "
    "measure the blobs and show their curvature.",
    { "ironProt.vtk" }, &BuildProtein });
}
