// SPDX-License-Identifier: BSD-3-Clause
// Gas that flows down onto a hot spinning disk: nested stream surfaces.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkClipPolyData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkNonMergingPointLocator.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProbeFilter.h"
#include "vtkProperty.h"
#include "vtkStructuredGrid.h"
#include "vtkTrivialProducer.h"

namespace
{
/// Radius of the vessel, z of its lid, and radius of the disk. Gas enters through the lid.
constexpr double RADIUS = 5.75;
constexpr double TOP = 10.1;
constexpr double DISK_RADIUS = 3.8;

/// Maximum advection time.
constexpr double TIME = 7.0;

/// Temperatures in K.
constexpr double COLD = 293.0;
constexpr double HOT = 913.0;

/// Inflow value of the innermost surface.
constexpr double INNERMOST = 0.25;

/// Returns the flow sampled on rings around the axis. The inflow value is the distance from the
/// axis divided by RADIUS.
gallery::MappedFlow MakeFlow(vtkDataSet* disk)
{
  disk->GetPointData()->SetActiveVectors("V");
  vtkNew<vtkTrivialProducer> field;
  field->SetOutput(disk);
  const vtkSmartPointer<vtkTerminationPlane> lid =
    gallery::MakeInflowPlane({ 0.0, 0.0, TOP }, { RADIUS, 0.0, 0.0 }, { 0.0, RADIUS, 0.0 });
  // With fewer samples around the axis, lines would have teeth in the shear near the disk.
  const vtkSmartPointer<vtkStructuredGrid> samples = gallery::MakeRings(nullptr,
    { { 49, 145, 145 }, { -2.5, TOP }, { 0.25, 1.25 },
      [](double outward, double) { return 0.3 + 5.4 * outward; } });
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(gallery::MakeImplicitFlow(field, { lid }, samples, 1.1 * TIME));
  mapping->SetFormula(vtkInflowMapping::ALL, "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  mapping->Update();
  return { vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0)), mapping, lid, 1.0 };
}

/// Returns the part of a stream surface where \a kept is positive, with streamlines and colored by
/// temperature. The surface starts on a circle of radius \a inflow * RADIUS.
vtkSmartPointer<vtkActor> MakeSurface(gallery::MappedFlow flow, double inflow,
  vtkImplicitFunction* kept, vtkDataSet* disk, vtkColorTransferFunction* colors)
{
  // Number of streamlines on the innermost surface. Their spacing at the lid is the same on all
  // surfaces.
  constexpr int lines = 16;
  flow.Length = 2.0 * vtkMath::Pi() * INNERMOST * RADIUS;
  vtkNew<vtkClipPolyData> cut;
  cut->SetInputData(gallery::MakeTexturedSurface(flow, inflow, 0.05, TIME, 1.0));
  cut->SetClipFunction(kept);
  // Keeps the points where the texture coordinates start anew.
  vtkNew<vtkNonMergingPointLocator> separate;
  cut->SetLocator(separate);
  cut->Update();
  vtkPolyData* surface = cut->GetOutput();
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(surface);
  probe->SetSourceData(disk);
  probe->Update();
  surface->GetPointData()->AddArray(probe->GetOutput()->GetPointData()->GetArray("Temp"));
  vtkSmartPointer<vtkActor> actor = gallery::MakeColoredActor(surface, "Temp", colors);
  // Makes the inside of folds bright enough.
  actor->GetProperty()->SetAmbient(0.8);
  actor->GetProperty()->SetDiffuse(0.3);
  // The streamline texture multiplies vertex colors, but not colors that the mapper looks up in a
  // texture.
  actor->GetMapper()->InterpolateScalarsBeforeMappingOff();
  const vtkSmartPointer<vtkStreamlineTexture> texture =
    gallery::MakeArcLengthTexture(24, gallery::TextColor(), lines);
  texture->SetLineWidth(0.2);
  vtkStreamlineTexture::AddTo(actor, texture, nullptr);
  return actor;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkDataSet> disk = interlume::ReadData("disk_out_ref.vtu");
  const gallery::MappedFlow flow = MakeFlow(disk);
  // The map starts below COLD, since its darkest colors would hide the lines.
  const vtkSmartPointer<vtkColorTransferFunction> colors =
    gallery::MakeColorMap(gallery::Map::Inferno, -100.0, HOT);
  gallery::Panel& panel = stage.AddPanel("", { 0.4, -1.0, -0.4 }, { 1.0, 0.0, 0.0 });
  panel.SetAmbientOcclusion(0.0);
  // The innermost surface ends around the disk. The other two are cut in half.
  vtkNew<vtkPlane> above;
  above->SetOrigin(0.0, 0.0, -0.5);
  above->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkPlane> back;
  back->SetNormal(0.0, 1.0, 0.0);
  panel.Add(MakeSurface(flow, INNERMOST, above, disk, colors));
  panel.Add(MakeSurface(flow, 0.5, back, disk, colors));
  // The outermost surface ends behind the other one, which it nearly touches farther on.
  const vtkSmartPointer<vtkActor> outermost = MakeSurface(flow, 0.75, back, disk, colors);
  vtkNew<vtkPlane> end;
  end->SetOrigin(0.0, 0.0, -1.5);
  outermost->GetMapper()->AddClippingPlane(end);
  panel.Add(outermost);
  vtkColor3d hot;
  colors->GetColor(HOT, hot.GetData());
  const vtkSmartPointer<vtkActor> plate = gallery::MakePillar(DISK_RADIUS, -1.0, -0.05, hot);
  plate->GetProperty()->SetAmbient(0.75);
  plate->GetProperty()->SetDiffuse(0.25);
  panel.Add(plate);
  stage.SetColorBar("temperature, K", colors, COLD, HOT);
}

const gallery::SceneRegistration registration(
  { "flow-disk", "4.7", "Streamlines as a texture on gas above a hot spinning disk",
    "Computed flow in a reactor, laid on its side. Cold gas enters through the lid, on the left. "
    "Hot gas that rises from the disk spreads it, and it leaves around the rim, where the rotation "
    "drags it along. Three nested stream surfaces start on circles at the lid; the outer two are "
    "cut in half, and the innermost one ends around the disk. The lines are streamlines at equal "
    "distances along these circles; the color is the temperature.",
    { "disk_out_ref.vtu" }, &Build });
}
