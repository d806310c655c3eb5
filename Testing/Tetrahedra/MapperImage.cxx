// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/MapperImage.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/VolumeStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

namespace reference
{

namespace
{

using Mapper = vtkTimeWeightedTetrahedraMapper;

void SelectScalars(vtkUnstructuredGridVolumeMapper* mapper, const MaterialArrays& arrays)
{
  if (arrays.Scalars.empty())
  {
    mapper->SetScalarMode(
      arrays.OfCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    return;
  }
  mapper->SetScalarMode(
    arrays.OfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(arrays.Scalars.c_str());
}

int ToBlendMode(Blend blend)
{
  switch (blend)
  {
    case Blend::MaximumIntensity:
      return Mapper::MAXIMUM_INTENSITY_BLEND;
    case Blend::Additive:
      return Mapper::ADDITIVE_BLEND;
    case Blend::Priority:
      return Mapper::PRIORITY_BLEND;
    case Blend::OpticalDepth:
      return Mapper::OPTICAL_DEPTH_BLEND;
    default:
      return Mapper::COMPOSITE_BLEND;
  }
}

RgbaImage Draw(
  VolumeStage& stage, vtkUnstructuredGridVolumeMapper* mapper, const ImageCase& what, int frames)
{
  stage.SetVolume(mapper, what.Property);
  stage.SetCamera(what.Camera);
  for (vtkActor* actor : what.Actors)
  {
    stage.AddActor(actor);
  }
  return stage.Capture(frames);
}

}

ImageCase MakeCase(vtkUnstructuredGrid* grid, vtkVolumeProperty* property, const Point3& direction,
  bool parallel, const std::array<int, 2>& size)
{
  ImageCase what;
  what.Grid = grid;
  what.Property = property;
  what.Camera = LookAt(grid, direction, parallel);
  what.Settings.Size = size;
  return what;
}

void Configure(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what)
{
  const CameraSettings& settings = what.Settings;
  mapper->SetInputData(static_cast<vtkDataSet*>(what.Grid));
  SelectScalars(mapper, settings.Arrays);
  mapper->SetBlendMode(ToBlendMode(settings.How));
  mapper->SetIntegrationMode(
    settings.Mode == Integration::Exact ? Mapper::LINEAR_SEGMENT : Mapper::AVERAGE_COLOR);
  mapper->SetDeltaTArrayName(settings.Arrays.DeltaT.c_str());
  mapper->SetLayerArrayName(settings.Layers.c_str());
  for (const auto& priority : settings.Priorities)
  {
    mapper->SetLayerPriority(priority.first, priority.second);
  }
}

RgbaImage DrawByMapper(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what)
{
  Configure(mapper, what);
  VolumeStage stage(what.Settings.Size);
  return Draw(stage, mapper, what, 1);
}

RgbaImage DrawByPath(int path, const ImageCase& what)
{
  vtkNew<Mapper> mapper;
  mapper->SetRenderPath(path);
  return DrawByMapper(mapper, what);
}

RgbaImage DrawByPath(int path, const ImageCase& what, VolumeStage& stage)
{
  vtkNew<Mapper> mapper;
  mapper->SetRenderPath(path);
  Configure(mapper, what);
  stage.GetWindow()->SetSize(what.Settings.Size[0], what.Settings.Size[1]);
  const RgbaImage image = Draw(stage, mapper, what, 1);
  for (vtkActor* actor : what.Actors)
  {
    stage.GetRenderer()->RemoveActor(actor);
  }
  mapper->ReleaseGraphicsResources(stage.GetWindow());
  return image;
}

RgbaImage DrawWithVtkMapper(const ImageCase& what)
{
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  mapper->SetInputData(static_cast<vtkDataSet*>(what.Grid));
  SelectScalars(mapper, what.Settings.Arrays);
  VolumeStage stage(what.Settings.Size);
  return Draw(stage, mapper, what, 2);
}

void AddPlane(ImageCase& what, double behind, const Point3& color)
{
  double focalPoint[3];
  what.Camera->GetFocalPoint(focalPoint);
  double normal[3];
  what.Camera->GetDirectionOfProjection(normal);
  double center[3];
  for (int k = 0; k < 3; ++k)
  {
    center[k] = focalPoint[k] + behind * normal[k];
  }
  normal[0] += 0.15;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-10.0, -10.0, 0.0);
  plane->SetPoint1(10.0, -10.0, 0.0);
  plane->SetPoint2(-10.0, 10.0, 0.0);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetNormal(normal);
  plane->SetCenter(center);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  what.Actors.push_back(actor);

  const PixelRays rays(what.Camera, what.Settings.Size);
  what.Settings.OpaqueDistance.clear();
  for (const auto& [j, i] : AllIndices(what.Settings.Size[1], what.Settings.Size[0]))
  {
    const Ray ray = rays.Get(i, j);
    const Vector n = { normal[0], normal[1], normal[2] };
    const Vector offset = { center[0] - ray.Origin[0], center[1] - ray.Origin[1],
      center[2] - ray.Origin[2] };
    what.Settings.OpaqueDistance.push_back(
      static_cast<double>(Dot(n, offset) / Dot(n, ray.Direction)));
  }
}

RgbaImage DrawReference(const ImageCase& what)
{
  return MakeReferenceImage(what.Grid, what.Property, what.Camera, what.Settings);
}

const std::vector<int>& AllRenderPaths()
{
  static const std::vector<int> paths = { Mapper::OPENGL_PATH, Mapper::SOFTWARE_PATH };
  return paths;
}

std::string GetPathName(int path)
{
  return path == Mapper::OPENGL_PATH ? "opengl" : "software";
}

}
