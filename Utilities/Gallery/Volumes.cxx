// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Volumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkTemporalColorTransferFunction.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

namespace gallery
{
namespace
{
vtkSmartPointer<vtkVolume> Make(vtkUnstructuredGrid* tetrahedra, int scalarMode,
  const std::string& array, vtkColorTransferFunction* colors, vtkPiecewiseFunction* extinction)
{
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputData(tetrahedra);
  mapper->SetScalarMode(scalarMode);
  mapper->SelectScalarArray(array.c_str());
  // Gallery images have no time limit, so level of detail is not needed.
  mapper->AutoAdjustLevelOfDetailOff();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  return volume;
}
}

vtkSmartPointer<vtkVolume> MakeVolume(vtkUnstructuredGrid* tetrahedra, const std::string& array,
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* extinction)
{
  return Make(tetrahedra, VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, array, colors, extinction);
}

vtkSmartPointer<vtkVolume> MakeVolumeOfIntervals(
  vtkUnstructuredGrid* tetrahedra, const std::vector<IntervalLook>& looks)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> extinction;
  for (std::size_t i = 0; i < looks.size(); ++i)
  {
    const auto id = static_cast<double>(i);
    const vtkColor3d& color = looks[i].Color;
    colors->AddRGBPoint(id, color[0], color[1], color[2]);
    extinction->AddPoint(id, looks[i].Extinction);
  }
  return Make(tetrahedra, VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, "IntervalId", colors, extinction);
}

vtkSmartPointer<vtkVolume> MakeTimeColoredVolume(
  vtkUnstructuredGrid* tetrahedra, const std::vector<double>& times, double extinction)
{
  vtkNew<vtkTemporalColorTransferFunction> colors;
  colors->SetTimes(static_cast<int>(times.size()), times.data());
  vtkNew<vtkPiecewiseFunction> constant;
  constant->AddPoint(times.front(), extinction);
  return MakeVolume(tetrahedra, "Time", colors, constant);
}

void SetBoundary(
  vtkVolume* volume, vtkUnstructuredGrid* triangles, const vtkColor3d& color, double opacity)
{
  vtkTimeWeightedTetrahedraMapper* mapper = GetMapper(volume);
  mapper->SetBoundaryData(triangles);
  vtkProperty* property = mapper->GetBoundaryProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(0.16);
  // Diffuse light is reduced, so that highlights are not clipped, which would change their hue.
  property->SetDiffuse(0.74);
  property->SetSpecular(0.3);
  property->SetSpecularPower(40.0);
}

vtkTimeWeightedTetrahedraMapper* GetMapper(vtkVolume* volume)
{
  return vtkTimeWeightedTetrahedraMapper::SafeDownCast(volume->GetMapper());
}
}
