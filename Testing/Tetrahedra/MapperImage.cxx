// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/MapperImage.h"

#include "Support/Images/CameraSettings.h"
#include "Support/Images/VolumeStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
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

RgbaImage Draw(vtkUnstructuredGridVolumeMapper* mapper, const ImageCase& what)
{
  VolumeStage stage(what.Settings.Size);
  stage.SetVolume(mapper, what.Property);
  stage.SetCamera(what.Camera);
  for (vtkActor* actor : what.Actors)
  {
    stage.AddActor(actor);
  }
  return stage.Capture();
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
  return Draw(mapper, what);
}

RgbaImage DrawByPath(int path, const ImageCase& what)
{
  vtkNew<Mapper> mapper;
  mapper->SetRenderPath(path);
  return DrawByMapper(mapper, what);
}

RgbaImage DrawWithVtkMapper(const ImageCase& what)
{
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  mapper->SetInputData(static_cast<vtkDataSet*>(what.Grid));
  SelectScalars(mapper, what.Settings.Arrays);
  return Draw(mapper, what);
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
