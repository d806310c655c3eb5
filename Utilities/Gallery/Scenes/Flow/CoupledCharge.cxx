// SPDX-License-Identifier: BSD-3-Clause
// Stream volume from a source to a sink, with five nested stream surfaces.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTerminationSphere.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr double HALF_SEPARATION = 0.5;
constexpr double RADIUS = 0.12;
constexpr double SPHERE_RADIUS = 0.15;

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> charges = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::COUPLED_CHARGE, { { 49, 49, 49 }, { -1.6, 1.6, -1.6, 1.6, -1.6, 1.6 } });
  vtkNew<vtkTerminationSphere> source;
  source->SetCenter(-HALF_SEPARATION, 0.0, 0.0);
  source->SetRadius(RADIUS);
  source->SetAxis(1.0, 0.0, 0.0);
  // Samples only the half y > 0, so that the nested surfaces appear cut open.
  const gallery::FlowGrid samples = { { 45, 31, 49 }, { -0.6, 0.6, 0.0, 0.67, -0.67, 0.67 } };
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(charges, { source }, samples), "1 - v");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.0, 0.42);
  std::vector<double> values = { 0.06, 0.13, 0.22, 0.32 };
  for (int i = 0; i < 4; ++i)
  {
    filter->SetStreamSurface(i, values[static_cast<std::size_t>(i)]);
  }
  filter->GenerateStreamSurfacesOn();
  filter->GenerateNormalsOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);

  // Each surface has the color of the volume at its inflow value.
  const vtkSmartPointer<vtkColorTransferFunction> map =
    gallery::MakeColorMap(gallery::Map::Viridis, 0.58, 0.0);
  values.push_back(0.0);
  values.push_back(0.42);
  std::sort(values.begin(), values.end());
  std::vector<vtkColor3d> colors;
  for (const double value : values)
  {
    vtkColor3d color;
    map->GetColor(value, color.GetData());
    colors.push_back(color);
  }
  vtkUnstructuredGrid* surfaces =
    vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(gallery::STREAM_SURFACES));
  gallery::SetStreamlineCoordinates(surfaces, 0, 12, 6);

  gallery::Panel& panel = stage.AddPanel("", { 0.25, -1.0, 0.5 });
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0.0, 0.5);
  vtkSmartPointer<vtkVolume> volume = gallery::MakeVolume(tetrahedra, "Inflow", map, extinction);
  gallery::SetTexturedBoundary(volume, surfaces, gallery::MakeStreamlineTexture(colors, 0.95));
  panel.Add(volume);
  panel.Add(
    gallery::MakeSphere({ -HALF_SEPARATION, 0.0, 0.0 }, SPHERE_RADIUS, gallery::IntervalColor(3)));
  panel.Add(
    gallery::MakeSphere({ HALF_SEPARATION, 0.0, 0.0 }, SPHERE_RADIUS, gallery::IntervalColor(0)));
}

const gallery::SceneRegistration registration(
  { "coupled-charge", "4.9", "Flow from a source to a sink, with five stream surfaces",
    "The field of two charges of opposite sign, cut in half. The red sphere around the source is "
    "the termination surface; the blue sphere surrounds the sink. Five nested stream surfaces "
    "start at different latitudes of the red sphere. The lines on them are streamlines at equal "
    "steps of longitude. The volume between them is colored by latitude.",
    {}, &Build });
}
