// SPDX-License-Identifier: BSD-3-Clause
// Streamlines as a texture whose mipmap levels are not averages: line density increases as the
// camera approaches.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSmoothPolyDataFilter.h"
#include "vtkStripper.h"
#include "vtkTubeFilter.h"

#include <cmath>

namespace
{
/// Radius of the marked line, for a view of size 1.
constexpr double LINE_RADIUS = 0.016;

/// Direction from which the camera looks.
const vtkVector3d FROM(0.4, -1.0, 0.5);

/// Returns the line of constant arc length that is nearest to \a point, among the lines that all
/// mipmap levels with at least eight lines share.
vtkSmartPointer<vtkPolyData> FindLine(vtkPolyData* surface, double point[3])
{
  vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
  vtkNew<vtkDoubleArray> arcLength;
  arcLength->SetName("ArcLength");
  arcLength->SetNumberOfTuples(coordinates->GetNumberOfTuples());
  arcLength->CopyComponent(0, coordinates, 0);
  vtkNew<vtkPolyData> scalars;
  scalars->CopyStructure(surface);
  scalars->GetPointData()->SetScalars(arcLength);
  vtkNew<vtkContourFilter> line;
  line->SetInputData(scalars);
  line->SetValue(0, std::round(8.0 * arcLength->GetValue(scalars->FindPoint(point))) / 8.0);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(line->GetOutputPort());
  // Smooths the corners of the line at the edges of triangles.
  vtkNew<vtkSmoothPolyDataFilter> smooth;
  smooth->SetInputConnection(stripper->GetOutputPort());
  smooth->SetNumberOfIterations(40);
  smooth->SetRelaxationFactor(0.2);
  smooth->Update();
  return smooth->GetOutput();
}

vtkSmartPointer<vtkActor> MakeTube(vtkPolyData* line, double radius)
{
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(radius);
  tube->SetNumberOfSides(16);
  tube->Update();
  return gallery::MakeActor(tube->GetOutput(), { 1.0, 0.84, 0.3 });
}

/// Returns the direction to the right as seen from FROM.
vtkVector3d GetRight()
{
  return vtkVector3d(-FROM[1], FROM[0], 0.0).Normalized();
}

/// Returns half the width of the view of \a box.
double GetHalfWidth(const vtkBoundingBox& box)
{
  const vtkVector3d right = GetRight();
  return 0.46 * (std::abs(right[0]) * box.GetLength(0) + std::abs(right[1]) * box.GetLength(1));
}

/// Returns the outline of the view of \a box, in front of the surface.
vtkSmartPointer<vtkActor> MakeOutline(const vtkBoundingBox& box)
{
  vtkVector3d center;
  box.GetCenter(center.GetData());
  const vtkVector3d toCamera = FROM.Normalized();
  const vtkVector3d across = 2.0 * GetHalfWidth(box) * GetRight();
  // The views are about twice as high as wide.
  const vtkVector3d along = 4.0 * GetHalfWidth(box) * toCamera.Cross(GetRight());
  const vtkVector3d corner = center + toCamera - 0.5 * across - 0.5 * along;
  vtkNew<vtkPlaneSource> rectangle;
  rectangle->SetOrigin(corner[0], corner[1], corner[2]);
  rectangle->SetPoint1((corner + across).GetData());
  rectangle->SetPoint2((corner + along).GetData());
  rectangle->Update();
  vtkSmartPointer<vtkActor> actor = gallery::MakeActor(rectangle->GetOutput(), { 1.0, 1.0, 1.0 });
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(2.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// Clips the actor at the left and right edges of \a box as seen from FROM, so that the images in
/// adjacent panels do not touch.
void CutSides(vtkActor* actor, const vtkBoundingBox& box)
{
  double center[3];
  box.GetCenter(center);
  const vtkVector3d right = GetRight();
  const double half = GetHalfWidth(box);
  for (const double side : { -1.0, 1.0 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(
      center[0] + side * half * right[0], center[1] + side * half * right[1], center[2]);
    plane->SetNormal(-side * right[0], -side * right[1], 0.0);
    actor->GetMapper()->AddClippingPlane(plane);
  }
}

/// Returns \a bounds, scaled around \a center.
vtkBoundingBox Scale(const double bounds[6], const double center[3], double factor)
{
  double part[6];
  for (int i = 0; i < 6; ++i)
  {
    part[i] = center[i / 2] + factor * (bounds[i] - center[i / 2]);
  }
  return vtkBoundingBox(part);
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkPolyData> surface =
    gallery::MakeTexturedSurface(gallery::MakeTornado(5.0, 2), 0.13, 0.45, 3.9, 16.0);
  // All panels share one texture.
  const vtkSmartPointer<vtkStreamlineTexture> lines =
    gallery::MakeArcLengthTexture(32, gallery::TextColor(), 512);
  const struct
  {
    const char* Caption;
    double Size;
  } views[] = { { "whole surface", 1.0 }, { "enlarged 3 times", 1.0 / 3.0 },
    { "enlarged 9 times", 1.0 / 9.0 } };
  double bounds[6];
  surface->GetBounds(bounds);
  // The closer views are centered on the marked line, on the part that faces the camera.
  double front[3] = { 0.0, -0.47, -0.3 };
  const vtkSmartPointer<vtkPolyData> line = FindLine(surface, front);
  double center[3];
  line->GetPoint(line->FindPoint(front), center);
  for (const auto& view : views)
  {
    gallery::Panel& panel = stage.AddPanel(view.Caption);
    panel.LookFrom(FROM, { 0.0, 0.0, 1.0 });
    panel.UseParallelProjection();
    // Ambient occlusion would add noise to the closer views.
    panel.SetAmbientOcclusion(0.0);
    const vtkSmartPointer<vtkActor> actors[] = { gallery::MakeActorWithLines(surface,
                                                   gallery::IntervalColor(0), lines, nullptr),
      MakeTube(line, LINE_RADIUS * view.Size) };
    for (vtkActor* actor : actors)
    {
      panel.Add(actor);
    }
    // All panels are framed by boxes, so that their scales have exactly these ratios.
    const vtkBoundingBox part = Scale(bounds, center, view.Size);
    panel.Frame(part);
    for (vtkActor* actor : actors)
    {
      CutSides(actor, part);
    }
    if (view.Size > 0.2)
    {
      panel.Add(MakeOutline(Scale(bounds, center, view.Size / 3.0)));
    }
  }
}

const gallery::SceneRegistration registration({ "streamline-zoom", "4.8",
  "More streamlines at closer distances",
  "A stream surface of a tornado, whole and enlarged, with the same texture. The yellow line is "
  "the same streamline in all three panels: more and more lines appear next to it. White outlines "
  "mark the enlarged parts. The texture is "
  "a mipmap pyramid whose levels have fewer and fewer lines of constant width in texels. No "
  "level is the average of another. New lines fade in between existing ones, so that their "
  "distance on screen is about the same at any scale.",
  {}, &Build });
}
