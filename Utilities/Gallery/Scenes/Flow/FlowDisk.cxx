// SPDX-License-Identifier: BSD-3-Clause
// Gas that comes down on a hot spinning disk: nested stream surfaces.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProbeFilter.h"
#include "vtkProperty.h"
#include "vtkTrivialProducer.h"

namespace
{
/// Of the vessel, whose axis is z, and where gas comes in.
constexpr double RADIUS = 5.75;
constexpr double TOP = 10.1;
constexpr double DISK_RADIUS = 3.8;

/// For how long gas is followed.
constexpr double TIME = 7.0;

/// Temperatures, K.
constexpr double COLD = 293.0;
constexpr double HOT = 913.0;

/// Half of the vessel, the distance from the axis as inflow: the cut shows how surfaces are nested.
gallery::MappedFlow MakeFlow(vtkDataSet* disk)
{
  disk->GetPointData()->SetActiveVectors("V");
  vtkNew<vtkTrivialProducer> field;
  field->SetOutput(disk);
  const vtkSmartPointer<vtkTerminationPlane> lid =
    gallery::MakeInflowPlane({ 0.0, 0.0, TOP }, { RADIUS, 0.0, 0.0 }, { 0.0, RADIUS, 0.0 });
  const gallery::FlowLattice samples = { { 65, 33, 77 }, { -5.7, 5.7, 0.0, 5.7, -3.5, TOP } };
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(gallery::MakeImplicitFlow(field, { lid }, samples, 1.1 * TIME));
  mapping->SetFormula(vtkInflowMapping::ALL, "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  mapping->Update();
  return { vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0)), mapping, lid, 1.0 };
}

/// The stream surface of gas that comes in at a share of RADIUS, with lines and temperature.
vtkSmartPointer<vtkActor> MakeSurface(
  gallery::MappedFlow flow, double inflow, vtkDataSet* disk, vtkColorTransferFunction* colours)
{
  flow.Length = 2.0 * vtkMath::Pi() * inflow * RADIUS;
  const vtkSmartPointer<vtkPolyData> surface =
    gallery::MakeTexturedSurface(flow, inflow, 0.05, TIME, 1.0);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(surface);
  probe->SetSourceData(disk);
  probe->Update();
  surface->GetPointData()->AddArray(probe->GetOutput()->GetPointData()->GetArray("Temp"));
  vtkSmartPointer<vtkActor> actor = gallery::MakeColouredActor(surface, "Temp", colours);
  // Lines multiply colours of vertices only.
  actor->GetMapper()->InterpolateScalarsBeforeMappingOff();
  const vtkSmartPointer<vtkStreamlineTexture> lines = gallery::MakeStreamlines(48, gallery::Ink());
  vtkStreamlineTexture::AddTo(actor, lines, nullptr);
  return actor;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkDataSet> disk = interlume::ReadData("disk_out_ref.vtu");
  const gallery::MappedFlow flow = MakeFlow(disk);
  // Without the darkest colours, on which lines are not seen.
  const vtkSmartPointer<vtkColorTransferFunction> colours =
    gallery::MakeColourMap(gallery::Map::Inferno, 100.0, HOT);
  gallery::Panel& panel = stage.AddPanel("", { 0.35, -1.0, 0.3 }, { 1.0, 0.0, 0.0 });
  for (const double inflow : { 0.3, 0.5, 0.7 })
  {
    panel.Add(MakeSurface(flow, inflow, disk, colours));
  }
  vtkColor3d hot;
  colours->GetColor(HOT, hot.GetData());
  const vtkSmartPointer<vtkActor> plate = gallery::MakePillar(DISK_RADIUS, -1.0, -0.05, hot);
  plate->GetProperty()->SetAmbient(0.5);
  plate->GetProperty()->SetDiffuse(0.5);
  panel.Add(plate);
  stage.SetColourBar("temperature, K", colours, COLD, HOT);
}

const gallery::SceneRegistration registration({ "flow-disk", "4.7",
  "Streamlines as a texture on gas that meets a hot spinning disk",
  "Computed flow in a reactor, laid on its side and cut in half. Cold gas comes in through the "
  "lid, "
  "on the left; hot gas that rises from the disk makes it spread, and it leaves around the rim, "
  "where the spin drags it along. Three stream surfaces, nested, of gas that comes in on circles; "
  "the lines on them are streamlines at equal distances along the circle, the colour is the "
  "temperature there.",
  { "disk_out_ref.vtu" }, &Build });
}
