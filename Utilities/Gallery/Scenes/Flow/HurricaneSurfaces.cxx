// SPDX-License-Identifier: BSD-3-Clause
// Four stream surfaces of a hurricane.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationCylinder.h"
#include "vtkTexture.h"

#include <vector>

namespace
{
void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> hurricane = gallery::MakeUprightHurricane();
  // Air enters through the lower part of the rim.
  vtkNew<vtkTerminationCylinder> rim;
  rim->SetPoint1(0.0, 0.0, -0.5);
  rim->SetPoint2(0.0, 0.0, 0.5);
  rim->SetRadius(1.25);
  const vtkSmartPointer<vtkStructuredGrid> samples = gallery::MakeRings(hurricane,
    { { 33, 73, 97 }, { -0.49, 0.49 }, { 0.0, 0.5 },
      [](double outward, double) { return 0.06 + 0.84 * outward; } });
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(hurricane, { rim }, samples, 12.0), "v");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.1, 0.29);
  filter->SetStreamSurface(0, 0.17);
  filter->SetStreamSurface(1, 0.23);
  filter->GenerateStreamSurfacesOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "Inflow"));
  vtkUnstructuredGrid* surfaces =
    vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(gallery::STREAM_SURFACES));
  gallery::SetGradientNormals(surfaces->GetPointData(), vtkIntervalVolume::LOWER_SIDE);
  std::vector<vtkSmartPointer<vtkTexture>> textures;
  for (int i = 0; i < 4; ++i)
  {
    textures.push_back(
      gallery::MakeGridTexture(24, 0, gallery::IntervalColor(i), gallery::TextColor(), 0.85));
  }

  gallery::Panel& panel = stage.AddPanel("", { 0.25, -1.0, 0.5 });
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0.0, 0.5);
  vtkSmartPointer<vtkVolume> volume = gallery::MakeVolume(
    tetrahedra, "Inflow", gallery::MakeColorMap(gallery::Map::Viridis, 0.0, 0.5), extinction);
  gallery::SetTexturedBoundary(volume, surfaces, "StreamSurfaceId", textures);
  panel.Add(volume);
}

const gallery::SceneRegistration registration(
  { "hurricane-surfaces", "4.10", "Four stream surfaces of a hurricane",
    "An analytic model of a hurricane, cut in half. Air enters through the lower half of the rim, "
    "a cylinder around the storm, rises in a ring around the eye and leaves at the top. The four "
    "stream surfaces start at different heights on the rim, blue lowest. The lines on them are "
    "streamlines, which show the swirl. The haze is the volume of this air.",
    {}, &Build });
}
