// SPDX-License-Identifier: BSD-3-Clause
// Liquid oxygen that parts around a post on a plate, with textured time surfaces.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Inputs/DataFiles.h"

#include "vtkActor.h"
#include "vtkAppendFilter.h"
#include "vtkDataSet.h"
#include "vtkFlowVolume.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationPlane.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double RADIUS = 0.5;
constexpr double HEIGHT = 3.0;

/// Of what is shown, around the post, whose axis is z: where it begins and ends along the flow, and
/// half its width.
constexpr double BEGIN = -2.4;
constexpr double END = 3.1;
constexpr double WIDTH = 1.9;

/// Points on lines from the post to the sides of a box, nearer to each other at the post and at the
/// plate.
vtkSmartPointer<vtkStructuredGrid> MakeSamples()
{
  constexpr int outward = 37;
  constexpr int around = 113;
  constexpr int upward = 33;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < upward; ++k)
  {
    const double height = HEIGHT * std::pow((k + 0.3) / (upward - 0.7), 1.5);
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * (j % (around - 1)) / (around - 1);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double side = std::min((x < 0.0 ? BEGIN : END) / x, WIDTH / std::abs(y));
      for (int i = 0; i < outward; ++i)
      {
        const double share = std::pow(static_cast<double>(i) / (outward - 1), 1.5);
        const double radius = (1.0 - share) * 1.01 * RADIUS + share * side;
        points->InsertNextPoint(radius * x, radius * y, height);
      }
    }
  }
  auto samples = vtkSmartPointer<vtkStructuredGrid>::New();
  samples->SetDimensions(outward, around, upward);
  samples->SetPoints(points);
  return samples;
}

void Build(gallery::Stage& stage)
{
  // The grid closes around the post; hexahedra of shared points let the flow pass where it does.
  vtkSmartPointer<vtkDataSet> post = interlume::ReadData("post.vts");
  vtkNew<vtkAppendFilter> joined;
  joined->AddInputData(post);
  joined->MergePointsOn();
  const vtkSmartPointer<vtkTerminationPlane> plane = gallery::MakeInflowPlane(
    { BEGIN, 0.0, 0.5 * HEIGHT }, { 0.0, 3.0, 0.0 }, { 0.0, 0.0, 0.5 * HEIGHT });
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(joined, { plane }, MakeSamples(), 15.0),
      "max(abs(u - 0.5) / 0.25, v / 0.9)");

  vtkNew<vtkFlowVolume> filter;
  filter->SetNumberOfIntervals(1);
  filter->SetInterval(0, 0.0, 1.0);
  filter->SetTimeRange(0.0, 4.2);
  filter->SetTimeSurface(0, 0.8);
  filter->SetTimeSurface(1, 2.6);
  filter->GenerateTimeSurfacesOn();
  filter->GenerateNormalsOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);

  gallery::Panel& panel = stage.AddPanel("");
  panel.LookFrom({ -0.55, -1.0, 0.6 }, { 0.0, 0.0, 1.0 });
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColour(0), 0.25 } }));
  for (int id = 0; id < 3; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetFlowSurface(filter, gallery::TIME_SURFACES, id + 1),
        gallery::MakeGridTexture(32, 16, gallery::IntervalColour(1 + id), gallery::Ink())));
  }
  panel.Add(gallery::MakePillar(RADIUS, 0.0, 1.1 * HEIGHT, gallery::Pencil()));
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(-2.9, -2.2, 0.0);
  plate->SetPoint1(3.3, -2.2, 0.0);
  plate->SetPoint2(-2.9, 2.2, 0.0);
  plate->Update();
  panel.Add(gallery::MakeActor(plate->GetOutput(), gallery::Pencil()));
}

const gallery::SceneRegistration registration(
  { "flow-post", "4.12", "Liquid oxygen that parts around a post, with three time surfaces",
    "Computed flow past a post on a plate, from the left. A grid of squares was laid on an upright "
    "rectangle in front of the post; the three surfaces are where the liquid has carried it after "
    "0.8, 2.6 and 4.2 units of time. At the plate it stands still, so that they lie down there; "
    "around the post they are held up and stretched, and pass it on both sides.",
    { "post.vts" }, &Build });
}
