// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Panel.h"

#include "Gallery/Look.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/SurfacesPass.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkMapper.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPointSet.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowedScenePass.h"
#include "vtkVolume.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gallery
{
namespace
{
/// Fraction of the panel's width or height that the fitted props fill.
constexpr double FILL = 0.95;

/// Number of points that approximate the outline of a surface to about a pixel.
constexpr vtkIdType OUTLINE_POINTS = 20000;

template <typename Visit>
void ForEachProp(vtkRenderer* renderer, const Visit& visit)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    visit(prop);
  }
}

/// Multiplies the line widths and point sizes of all actors by a factor. The destructor restores
/// them.
class LineScale
{
public:
  LineScale(vtkRenderer* renderer, double factor)
  {
    ForEachProp(renderer,
      [this](vtkProp* prop)
      {
        if (auto* actor = vtkActor::SafeDownCast(prop))
        {
          vtkProperty* property = actor->GetProperty();
          this->Sizes[property] = { property->GetLineWidth(), property->GetPointSize() };
        }
      });
    this->Apply(factor);
  }
  ~LineScale() { this->Apply(1.0); }
  LineScale(const LineScale&) = delete;
  void operator=(const LineScale&) = delete;

private:
  void Apply(double factor)
  {
    for (const auto& [property, size] : this->Sizes)
    {
      property->SetLineWidth(static_cast<float>(factor * size[0]));
      property->SetPointSize(static_cast<float>(factor * size[1]));
    }
  }

  std::map<vtkProperty*, std::array<double, 2>> Sizes;
};

/// Returns the point set that a prop renders, or nullptr if the prop is transformed or its input is
/// not a point set.
vtkPointSet* GetShape(vtkProp* prop)
{
  auto* prop3D = vtkProp3D::SafeDownCast(prop);
  if (!prop3D || !prop3D->GetIsIdentity())
  {
    return nullptr;
  }
  vtkAlgorithm* mapper = nullptr;
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    mapper = actor->GetMapper();
  }
  else if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    mapper = volume->GetMapper();
  }
  if (!mapper)
  {
    return nullptr;
  }
  mapper->Update();
  return vtkPointSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

void AppendCorners(const double bounds[6], std::vector<vtkVector3d>& points)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    points.emplace_back(
      bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)]);
  }
}
}

Panel::Panel(const std::string& caption)
  : Caption(caption)
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Camera(vtkSmartPointer<vtkCamera>::New())
{
  ApplyLook(this->Renderer);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Camera->SetViewAngle(22.0);
  this->LookFrom({ 0.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 });
}

void Panel::Add(vtkProp* prop)
{
  this->Renderer->AddViewProp(prop);
}

void Panel::LookFrom(const vtkVector3d& from, const vtkVector3d& up)
{
  this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Camera->SetPosition(from[0], from[1], from[2]);
  this->Camera->SetViewUp(up[0], up[1], up[2]);
  this->Camera->OrthogonalizeViewUp();
}

void Panel::ShareCamera(Panel& other)
{
  this->Camera = other.Camera;
  this->Renderer->SetActiveCamera(this->Camera);
}

void Panel::SetBackground(const vtkColor3d& color)
{
  this->Renderer->SetBackground(color[0], color[1], color[2]);
}

void Panel::SetBackground(const vtkColor3d& lower, const vtkColor3d& upper)
{
  this->SetBackground(lower);
  this->Renderer->SetBackground2(upper[0], upper[1], upper[2]);
  this->Renderer->GradientBackgroundOn();
}

void Panel::SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights)
{
  this->Renderer->RemoveAllLights();
  for (const vtkSmartPointer<vtkLight>& light : lights)
  {
    this->Renderer->AddLight(light);
  }
}

bool Panel::UsesAmbientOcclusion() const
{
  bool hasSurface = false;
  ForEachProp(this->Renderer,
    [&hasSurface](vtkProp* prop) { hasSurface = hasSurface || prop->IsA("vtkActor"); });
  return this->OcclusionReach > 0.0 && hasSurface;
}

void Panel::PreparePasses()
{
  // vtkShadowedScenePass draws both surfaces and volumes, so other passes are not needed.
  if (vtkShadowedScenePass::SafeDownCast(this->Renderer->GetPass()))
  {
    return;
  }
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(lights);
  if (this->UsesAmbientOcclusion())
  {
    vtkNew<vtkSSAOPass> occlusion;
    vtkNew<vtkCameraPass> inner;
    inner->SetDelegatePass(opaque);
    occlusion->SetDelegatePass(inner);
    occlusion->SetRadius(this->OcclusionReach * this->GetBox().GetDiagonalLength());
    occlusion->SetBias(0.04 * occlusion->GetRadius());
    occlusion->SetKernelSize(48);
    occlusion->BlurOn();
    vtkNew<SurfacesPass> surfaces;
    surfaces->SetDelegatePass(occlusion);
    passes->AddItem(surfaces);
  }
  else
  {
    passes->AddItem(opaque);
  }
  vtkNew<vtkVolumetricPass> volumes;
  passes->AddItem(volumes);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkOpenGLRenderer::SafeDownCast(this->Renderer)->SetPass(camera);
}

vtkSmartPointer<vtkImageData> Panel::Draw(int width, int height, double lineScale)
{
  const LineScale scale(this->Renderer, lineScale);
  // Each panel is drawn in a separate window, since vtkSSAOPass of VTK 9.1 requires that the
  // renderer covers the window.
  this->PreparePasses();
  this->Pixels = static_cast<vtkIdType>(width) * height;
  vtkSmartPointer<vtkRenderWindow> window = MakeWindow(width, height);
  window->AddRenderer(this->Renderer);
  return this->DrawIn(window);
}

vtkSmartPointer<vtkImageData> Panel::DrawIn(vtkRenderWindow* window)
{
  double bounds[6];
  this->GetBox().GetBounds(bounds);
  this->Renderer->ResetCameraClippingRange(bounds);
  return GrabImage(window);
}

vtkBoundingBox Panel::GetBox() const
{
  double bounds[6];
  this->Renderer->ComputeVisiblePropBounds(bounds);
  return vtkBoundingBox(bounds);
}

std::vector<vtkVector3d> Panel::GetPoints() const
{
  std::vector<vtkVector3d> points;
  if (this->FramedBox.IsValid())
  {
    double bounds[6];
    this->FramedBox.GetBounds(bounds);
    AppendCorners(bounds, points);
    return points;
  }
  ForEachProp(this->Renderer,
    [&points](vtkProp* prop)
    {
      vtkPointSet* shape = GetShape(prop);
      if (!shape)
      {
        AppendCorners(prop->GetBounds(), points);
        return;
      }
      const vtkIdType count = shape->GetNumberOfPoints();
      const vtkIdType step = std::max<vtkIdType>(1, count / OUTLINE_POINTS);
      for (vtkIdType i = 0; i < count; i += step)
      {
        points.emplace_back(shape->GetPoint(i));
      }
    });
  return points;
}

void Panel::Fit(const std::vector<vtkVector3d>& points, double aspect)
{
  if (points.empty())
  {
    return;
  }
  // In a perspective view, the size of the props on screen depends on the distance. A few
  // iterations of panning and dollying are sufficient.
  const double pi = 3.14159265358979323846;
  const double slope = std::tan(0.5 * this->Camera->GetViewAngle() * pi / 180.0);
  vtkVector3d from(this->Camera->GetPosition());
  vtkVector3d focus(this->Camera->GetFocalPoint());
  from = from - focus;
  from.Normalize();
  vtkVector3d up(this->Camera->GetViewUp());
  const vtkVector3d right = up.Cross(from).Normalized();
  up = from.Cross(right).Normalized();

  vtkBoundingBox box;
  for (vtkVector3d point : points)
  {
    box.AddPoint(point.GetData());
  }
  box.GetCenter(focus.GetData());
  const bool isParallel = this->Camera->GetParallelProjection() != 0;
  double distance = 2.0 * box.GetDiagonalLength() / slope;
  for (int round = 0; round < 12; ++round)
  {
    double low[2] = { 1e300, 1e300 };
    double high[2] = { -1e300, -1e300 };
    double nearest = 1e300;
    for (vtkVector3d point : points)
    {
      const vtkVector3d offset = point - focus;
      const double depth =
        isParallel ? distance : std::max(distance - offset.Dot(from), 1e-3 * distance);
      nearest = std::min(nearest, depth);
      const double projected[2] = { offset.Dot(right) / (depth * slope * aspect),
        offset.Dot(up) / (depth * slope) };
      for (int axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], projected[axis]);
        high[axis] = std::max(high[axis], projected[axis]);
      }
    }
    const double half = 0.5 * std::max(high[0] - low[0], high[1] - low[1]);
    focus = focus + right * (0.5 * (low[0] + high[0]) * distance * slope * aspect) +
      up * (0.5 * (low[1] + high[1]) * distance * slope);
    distance += nearest * (half / FILL - 1.0);
  }
  this->Camera->SetFocalPoint(focus.GetData());
  const vtkVector3d position = focus + from * distance;
  this->Camera->SetParallelScale(distance * slope);
  this->Camera->SetPosition(position.GetData());
  this->Camera->SetViewUp(up.GetData());
}
}
