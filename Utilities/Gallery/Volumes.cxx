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
  const std::string& array, vtkColorTransferFunction* colours, vtkPiecewiseFunction* extinction)
{
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputData(tetrahedra);
  mapper->SetScalarMode(scalarMode);
  mapper->SelectScalarArray(array.c_str());
  // A picture of the gallery takes the time it takes.
  mapper->AutoAdjustLevelOfDetailOff();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colours);
  volume->GetProperty()->SetScalarOpacity(extinction);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  return volume;
}
}

vtkSmartPointer<vtkVolume> MakeVolume(vtkUnstructuredGrid* tetrahedra, const std::string& array,
  vtkColorTransferFunction* colours, vtkPiecewiseFunction* extinction)
{
  return Make(tetrahedra, VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, array, colours, extinction);
}

vtkSmartPointer<vtkVolume> MakeVolumeOfIntervals(
  vtkUnstructuredGrid* tetrahedra, const std::vector<IntervalLook>& looks)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> extinction;
  for (std::size_t i = 0; i < looks.size(); ++i)
  {
    const auto id = static_cast<double>(i);
    const vtkColor3d& colour = looks[i].Colour;
    colours->AddRGBPoint(id, colour[0], colour[1], colour[2]);
    extinction->AddPoint(id, looks[i].Extinction);
  }
  return Make(tetrahedra, VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, "IntervalId", colours, extinction);
}

vtkSmartPointer<vtkVolume> MakeVolumeInTime(
  vtkUnstructuredGrid* tetrahedra, const std::vector<double>& times, double extinction)
{
  vtkNew<vtkTemporalColorTransferFunction> colours;
  colours->SetTimes(static_cast<int>(times.size()), times.data());
  vtkNew<vtkPiecewiseFunction> constant;
  constant->AddPoint(times.front(), extinction);
  return MakeVolume(tetrahedra, "Time", colours, constant);
}

void SetBoundary(
  vtkVolume* volume, vtkUnstructuredGrid* triangles, const vtkColor3d& colour, double opacity)
{
  vtkTimeWeightedTetrahedraMapper* mapper = GetMapper(volume);
  mapper->SetBoundaryData(triangles);
  vtkProperty* property = mapper->GetBoundaryProperty();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(0.16);
  // Less diffuse light leaves room for the highlight, which would lose its hue where it is cut off.
  property->SetDiffuse(0.74);
  property->SetSpecular(0.3);
  property->SetSpecularPower(40.0);
}

vtkTimeWeightedTetrahedraMapper* GetMapper(vtkVolume* volume)
{
  return vtkTimeWeightedTetrahedraMapper::SafeDownCast(volume->GetMapper());
}
}
