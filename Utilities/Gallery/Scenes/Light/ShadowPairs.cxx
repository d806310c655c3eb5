// SPDX-License-Identifier: BSD-3-Clause
// Objects on and above a floor, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Protein.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"
#include "vtkNew.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialTurbulence.h"

namespace
{
void BuildSphereShadow(gallery::Stage& stage)
{
  vtkNew<vtkSpatialPrimitive> fuzzy;
  fuzzy->SetShape(vtkSpatialPrimitive::FUZZY_SPHERE);
  fuzzy->SetRadius(0.5);
  fuzzy->SetInnerRadius(0.2);
  vtkSmartPointer<vtkImageData> image = gallery::Sample(gallery::MakeFloor({ 0.86, 0.80, 0.70 }),
    vtkBoundingBox(-1.2, 1.9, -1.35, 2.4, -0.06, 1.16), 250);
  gallery::AddSmoke(image, gallery::Place(fuzzy, { 0.0, 0.0, 0.6 }), 0.24, { 0.27, 0.45, 0.68 });
  const double opacity = 0.075;
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMediumInSmoke(image, opacity),
      gallery::MakeStudioLights({ -1.9, -1.1, 3.6 }, 0.95), 3.0 * gallery::SMOKE_GRADIENT);
  pair.SetBackground({ 0.90, 0.88, 0.84 }, { 0.55, 0.62, 0.68 });
  // From this height, the floor fills the image. Its far edge would have a bright rim.
  pair.Look({ 0.1, -1.0, 1.5 }, vtkBoundingBox(-0.52, 1.06, -0.1, 0.1, -0.3, 1.1));
}

const gallery::SceneRegistration sphereShadow(
  { "sphere-shadow", "2.5", "A fuzzy sphere over a floor, without and with shadows",
    "The sphere is dense inside and its density decreases to the border. With shadows it is darker "
    "on the side away from the point light, and its shadow on the floor is soft.",
    {}, &BuildSphereShadow });

void BuildCurvedShadows(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::SoftenEdges(vtkConstructiveModelSource::MakeModel(
                                      vtkConstructiveModelSource::TWO_SPHERES)),
                       { 0.0, 0.0, 0.5 }, -60.0),
      gallery::MakeFloor({ 0.86, 0.80, 0.70 }) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.25, 1.05, -1.0, 0.9, -0.06, 1.35), 210, 1.6);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -0.9, -1.7, 3.8 }, 0.95));
  pair.SetBackground({ 0.90, 0.88, 0.84 }, { 0.55, 0.62, 0.68 });
  pair.Look({ 0.2, -1.0, 0.75 }, vtkBoundingBox(-0.66, 0.7, -0.1, 0.1, -0.42, 1.4));
}

const gallery::SceneRegistration curvedShadows(
  { "curved-shadows", "2.11", "Curved shadows on curved objects, without and with shadows",
    "A small sphere is joined to a large one. Its shadow curves over the large sphere and "
    "continues on the floor.",
    {}, &BuildCurvedShadows });

/// Returns the model of a bear with fur of short strands, which hang down.
vtkSmartPointer<vtkSpatialObject> MakeFurryBear()
{
  vtkSmartPointer<vtkSpatialObject> bear =
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::TEDDY_BEAR);
  auto* parts = vtkSpatialOperation::SafeDownCast(bear);
  auto* fur =
    vtkSpatialTurbulence::SafeDownCast(parts->GetOperand(parts->GetNumberOfOperands() - 1));
  fur->SetFrequency(46.0, 46.0, 14.0);
  fur->SetNumberOfOctaves(2);
  fur->SetAmplitude(0.7);
  return bear;
}

void BuildTeddyBear(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(MakeFurryBear(), { 0.0, 0.1, 0.0 }, 20.0),
      gallery::MakeFloor({ 0.66, 0.52, 0.40 }) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.95, 1.0, -0.8, 1.1, -0.06, 1.4), 266, 0.8);
  gallery::ShadowPair pair = gallery::AddShadowPair(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -0.9, -2.1, 4.1 }));
  pair.SetBackground({ 0.93, 0.88, 0.78 }, { 0.52, 0.60, 0.68 });
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.6, 0.72, -0.1, 0.1, -0.27, 1.38));
}

const gallery::SceneRegistration teddyBear(
  { "teddy-bear", "2.13", "A teddy bear, without and with shadows",
    "A blend of ellipsoids with strands of fur from noise. The dissertation shows a scanned bear. "
    "With shadows, the head shades the body and the legs shade the ground, and the fur has depth.",
    {}, &BuildTeddyBear });

void BuildProteinShadows(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::MakeProtein(), { 0.0, 0.0, 0.52 }, 100.0),
      gallery::SoftenEdges(gallery::MakeFloor({ 0.62, 0.67, 0.72 }), 0.03) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.0, 1.0, -1.02, 0.9, -0.05, 1.05), 220, 0.7);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -0.5, -1.1, 3.8 }, 0.95));
  pair.SetBackground({ 0.70, 0.76, 0.83 }, { 0.20, 0.26, 0.36 });
  pair.Look({ 0.0, -1.0, 0.6 }, vtkBoundingBox(-0.5, 0.66, -0.1, 0.1, -0.24, 1.08));
}

const gallery::SceneRegistration proteinShadows(
  { "protein", "2.10", "A protein, without and with shadows",
    "The absolute value of an electron's wave function in a high-potential iron protein, as blobs "
    "around its maxima. The shadows show which blob is in front of another, and how high each is "
    "above the floor.",
    { "ironProt.vtk" }, &BuildProteinShadows });
}
