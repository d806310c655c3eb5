// SPDX-License-Identifier: BSD-3-Clause
// Stream volume from a source to a sink, with five nested stream surfaces.

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
#include "vtkTerminationSphere.h"
#include "vtkTexture.h"

#include <vector>

namespace
{
constexpr double RADIUS = 0.1;
constexpr double SPHERE_RADIUS = 0.15;

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> charges = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::COUPLED_CHARGE, { { 81, 81, 81 }, { -1.6, 1.6, -1.6, 1.6, -1.6, 1.6 } });
  charges->SetSeparation(0.0, 0.0, 1.0);
  vtkNew<vtkTerminationSphere> source;
  source->SetCenter(0.0, 0.0, -0.5);
  source->SetRadius(RADIUS);
  // Samples a little less than half of each ring, so that the nested surfaces appear cut open and
  // their cut ends are behind the spheres.
  const vtkSmartPointer<vtkStructuredGrid> samples =
    gallery::MakeArcs({ { 33, 49, 65 } }, { { -0.28, 0.187 } });
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(charges, { source }, samples), "1 - v");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.0, 0.38);
  std::vector<double> values = { 0.07, 0.13, 0.2, 0.28 };
  for (int i = 0; i < 4; ++i)
  {
    filter->SetStreamSurface(i, values[static_cast<std::size_t>(i)]);
  }
  filter->GenerateStreamSurfacesOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "Inflow"));

  // Each surface has the color of the volume at its inflow value. The innermost one is the axis.
  const vtkSmartPointer<vtkColorTransferFunction> map =
    gallery::MakeColorMap(gallery::Map::Viridis, 0.56, 0.0);
  values.push_back(0.38);
  std::vector<vtkSmartPointer<vtkTexture>> textures = { nullptr };
  for (const double value : values)
  {
    vtkColor3d color;
    map->GetColor(value, color.GetData());
    textures.push_back(gallery::MakeGridTexture(16, 0, color, gallery::TextColor(), 0.8));
  }
  vtkUnstructuredGrid* surfaces =
    vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(gallery::STREAM_SURFACES));
  gallery::SetGradientNormals(surfaces->GetPointData(), vtkIntervalVolume::LOWER_SIDE);

  gallery::Panel& panel = stage.AddPanel("", { -1.0, 0.3, 0.0 }, { 0.0, 1.0, 0.0 });
  panel.UseParallelProjection();
  gallery::LightFromAllSides(panel);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0.0, 0.8);
  vtkSmartPointer<vtkVolume> volume = gallery::MakeVolume(tetrahedra, "Inflow", map, extinction);
  gallery::SetTexturedBoundary(volume, surfaces, "StreamSurfaceId", textures);
  panel.Add(volume);
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, -0.5 }, SPHERE_RADIUS, gallery::IntervalColor(3)));
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.5 }, SPHERE_RADIUS, gallery::IntervalColor(0)));
}

const gallery::SceneRegistration registration(
  { "coupled-charge", "4.9", "Flow from a source to a sink, with five stream surfaces",
    "The field of two charges of opposite sign, cut in half. The red sphere around the source "
    "encloses the termination surface, a smaller sphere; the blue sphere surrounds the sink. Five "
    "nested stream surfaces start at different latitudes of the termination surface. The lines on "
    "them are streamlines at equal steps of longitude. The colors of the surfaces and of the thin "
    "volume between them show the latitude.",
    {}, &Build });
}
