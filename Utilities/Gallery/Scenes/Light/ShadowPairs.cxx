// SPDX-License-Identifier: BSD-3-Clause
// Objects above a plate, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Protein.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"
#include "vtkNew.h"

namespace
{
void BuildSphereShadow(gallery::Stage& stage)
{
  vtkNew<vtkSpatialPrimitive> fuzzy;
  fuzzy->SetShape(vtkSpatialPrimitive::FUZZY_SPHERE);
  fuzzy->SetRadius(0.5);
  fuzzy->SetInnerRadius(0.2);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.85, 0.06, gallery::Plaster()),
      vtkBoundingBox(-0.9, 0.9, -0.9, 0.9, -0.1, 1.16), 160);
  gallery::AddSmoke(image, gallery::Place(fuzzy, { 0.0, 0.0, 0.6 }), 0.24, { 0.27, 0.45, 0.68 });
  const double opacity = 0.075;
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMediumInSmoke(image, opacity),
      gallery::MakeStudioLights({ -1.6, -1.2, 3.4 }, 0.9), 3.0 * gallery::SMOKE_GRADIENT);
  pair.Look({ 0.2, -1.0, 0.75 }, vtkBoundingBox(-0.84, 0.84, -0.1, 0.1, -0.35, 1.15));
}

const gallery::SceneRegistration sphereShadow(
  { "sphere-shadow", "2.5", "A fuzzy sphere over a plate, without and with shadows",
    "The sphere is dense inside and its density decreases to the border. With shadows it is darker "
    "on the side away from the point light, and its shadow on the plate is soft.",
    {}, &BuildSphereShadow });

void BuildCurvedShadows(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::Soften(vtkConstructiveModelSource::MakeModel(
                                      vtkConstructiveModelSource::TWO_SPHERES)),
                       { 0.0, 0.0, 0.5 }, -60.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.85, 0.05, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.9, 0.9, -0.9, 0.9, -0.1, 1.35), 160);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -1.9, -2.3, 3.2 }, 0.9));
  pair.Look({ 0.2, -1.0, 0.75 }, vtkBoundingBox(-0.84, 0.84, -0.1, 0.1, -0.4, 1.3));
}

const gallery::SceneRegistration curvedShadows(
  { "curved-shadows", "2.11", "Curved shadows on curved objects, without and with shadows",
    "A small sphere is joined to a large one. Its shadow curves over the large sphere and "
    "continues on the disk.",
    {}, &BuildCurvedShadows });

void BuildTeddyBear(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::TEDDY_BEAR),
        { 0.0, 0.1, 0.0 }, 20.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.74, 0.05, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.77, 0.77, -0.77, 0.77, -0.1, 1.4), 180, 0.8);
  gallery::ShadowPair pair = gallery::AddShadowPair(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.0, -2.0, 3.0 }));
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.73, 0.73, -0.1, 0.1, -0.3, 1.36));
}

const gallery::SceneRegistration teddyBear(
  { "teddy-bear", "2.13", "A teddy bear, without and with shadows",
    "A blend of ellipsoids with fur from noise. The dissertation shows a scanned bear. With "
    "shadows, the head shades the body and the legs shade the ground, and the fur has depth.",
    {}, &BuildTeddyBear });

void BuildProteinShadows(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::MakeProtein(), { 0.0, 0.0, 0.52 }, 90.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.7, 0.04, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.73, 0.73, -0.73, 0.73, -0.08, 1.05), 170, 0.7);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85));
  pair.Look({ 0.0, -1.0, 0.55 }, vtkBoundingBox(-0.69, 0.69, -0.1, 0.1, -0.3, 1.02));
}

const gallery::SceneRegistration proteinShadows(
  { "protein", "2.10", "A protein, without and with shadows",
    "The absolute value of an electron's wave function in a high-potential iron protein, as blobs "
    "around its maxima. The shadows show which blob is in front of another, and how high each is "
    "above the disk.",
    { "ironProt.vtk" }, &BuildProteinShadows });
}
