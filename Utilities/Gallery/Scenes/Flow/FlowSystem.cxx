// SPDX-License-Identifier: BSD-3-Clause
// A stream volume with stream surfaces, streamlines, time surfaces and timelines in one image.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFlowVolume.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationSphere.h"
#include "vtkTexture.h"

#include <vector>

namespace
{
constexpr double MAXIMUM = 0.38;
/// Values of Inflow on the stream surfaces. The first one is the axis, which is not drawn.
const std::vector<double> STREAM_VALUES = { 0.0, 0.13, 0.25, MAXIMUM };
const std::vector<double> TIMES = { 0.012, 0.03, 0.06 };

/// Returns surfaces with the ids of their triangles, which begin at \a first, in the cell array
/// `SurfaceId`.
vtkSmartPointer<vtkUnstructuredGrid> GetSurfaces(vtkFlowVolume* filter, int port, int first)
{
  auto surfaces = vtkSmartPointer<vtkUnstructuredGrid>::New();
  surfaces->ShallowCopy(filter->GetOutputDataObject(port));
  vtkDataArray* ids = surfaces->GetCellData()->GetArray(
    port == gallery::STREAM_SURFACES ? "StreamSurfaceId" : "TimeSurfaceId");
  vtkNew<vtkIntArray> all;
  all->SetName("SurfaceId");
  for (vtkIdType cell = 0; cell < surfaces->GetNumberOfCells(); ++cell)
  {
    all->InsertNextValue(first + static_cast<int>(ids->GetComponent(cell, 0)));
  }
  surfaces->GetCellData()->AddArray(all);
  return surfaces;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> charges = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::COUPLED_CHARGE, { { 81, 81, 81 }, { -1.6, 1.6, -1.6, 1.6, -1.6, 1.6 } });
  charges->SetSeparation(0.0, 0.0, 1.0);
  vtkNew<vtkTerminationSphere> source;
  source->SetCenter(0.0, 0.0, -0.5);
  source->SetRadius(0.1);
  const vtkSmartPointer<vtkStructuredGrid> samples =
    gallery::MakeArcs({ { 33, 49, 65 } }, { { -0.28, 0.187 } });
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(charges, { source }, samples), "1 - v");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, STREAM_VALUES.front(), STREAM_VALUES.back());
  for (int i = 0; i < 2; ++i)
  {
    filter->SetStreamSurface(i, STREAM_VALUES[static_cast<std::size_t>(i) + 1]);
  }
  for (int i = 0; i < static_cast<int>(TIMES.size()); ++i)
  {
    filter->SetTimeSurface(i, TIMES[static_cast<std::size_t>(i)]);
  }
  filter->GenerateStreamSurfacesOn();
  filter->GenerateTimeSurfacesOn();
  filter->GenerateNormalsOn();
  filter->ParametersAsTextureCoordinatesOn();
  const vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);
  vtkNew<vtkAppendFilter> surfaces;
  surfaces->AddInputData(GetSurfaces(filter, gallery::STREAM_SURFACES, 0));
  surfaces->AddInputData(
    GetSurfaces(filter, gallery::TIME_SURFACES, static_cast<int>(STREAM_VALUES.size())));
  surfaces->Update();

  const vtkSmartPointer<vtkColorTransferFunction> map =
    gallery::MakeColorMap(gallery::Map::Viridis, 0.56, 0.0);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0.0, 0.6);
  vtkSmartPointer<vtkVolume> volume = gallery::MakeVolume(tetrahedra, "Inflow", map, extinction);
  std::vector<vtkSmartPointer<vtkTexture>> textures = { nullptr };
  for (std::size_t i = 1; i < STREAM_VALUES.size(); ++i)
  {
    vtkColor3d color;
    map->GetColor(STREAM_VALUES[i], color.GetData());
    textures.push_back(gallery::MakeGridTexture(16, 0, color, gallery::TextColor(), 0.55));
  }
  // The timelines began on the circles of latitude of the sphere.
  textures.resize(STREAM_VALUES.size() + TIMES.size() + 2,
    gallery::MakeGridTexture(16, 24, { 1.0, 0.85, 0.35 }, gallery::TextColor(), 0.75));
  gallery::SetTexturedBoundary(volume, surfaces->GetOutput(), "SurfaceId", textures);

  gallery::Panel& panel = stage.AddPanel("", { -1.0, 0.3, 0.0 }, { 0.0, 1.0, 0.0 });
  panel.UseParallelProjection();
  gallery::LightFromAllSides(panel);
  panel.Add(volume);
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, -0.5 }, 0.15, gallery::IntervalColor(3)));
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.5 }, 0.15, gallery::IntervalColor(0)));
}

const gallery::SceneRegistration registration(
  { "flow-system", "4.9", "Stream volume, stream and time surfaces, streamlines and timelines",
    "The field of two charges of opposite sign, cut in half, with the source (red) on the left. "
    "One mapper draws a thin stream volume and, inside it, translucent stream surfaces with "
    "streamlines, in the colors of the volume, and three time surfaces (yellow) with timelines.",
    {}, &Build });
}
