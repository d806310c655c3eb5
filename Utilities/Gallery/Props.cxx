// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Props.h"

#include "Gallery/Look.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGradientFilter.h"
#include "vtkIdList.h"
#include "vtkImageShrink3D.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkStructuredGrid.h"
#include "vtkStructuredGridGeometryFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVector.h"

namespace gallery
{
namespace
{
const char* const GRADIENT = "Gradient";
}

void SetGradientNormals(vtkPointData* pointData, int side)
{
  vtkDataArray* vectors = pointData->GetArray(GRADIENT);
  const double sign = side == vtkIntervalVolume::LOWER_SIDE ? -1.0 : 1.0;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    vtkVector3d normal;
    vectors->GetTuple(i, normal.GetData());
    normal.Normalize();
    normals->SetTuple3(i, sign * normal[0], sign * normal[1], sign * normal[2]);
  }
  pointData->SetNormals(normals);
}

vtkSmartPointer<vtkUnstructuredGrid> SelectTriangles(
  vtkUnstructuredGrid* triangles, const std::string& array, int value)
{
  vtkDataArray* values = triangles->GetCellData()->GetArray(array.c_str());
  auto selected = vtkSmartPointer<vtkUnstructuredGrid>::New();
  selected->SetPoints(triangles->GetPoints());
  selected->GetPointData()->ShallowCopy(triangles->GetPointData());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    if (values->GetComponent(cell, 0) == value)
    {
      triangles->GetCellPoints(cell, corners);
      selected->InsertNextCell(VTK_TRIANGLE, corners);
    }
  }
  return selected;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeBoundary(vtkIntervalVolume* filter, int side)
{
  vtkSmartPointer<vtkUnstructuredGrid> selected = SelectTriangles(
    vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1)), "BoundarySide", side);
  SetGradientNormals(selected->GetPointData(), side);
  return selected;
}

vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* cells, double featureAngle)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(cells);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SetFeatureAngle(featureAngle);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* surface, const vtkColor3d& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(0.16);
  property->SetDiffuse(0.88);
  property->SetSpecular(0.12);
  property->SetSpecularPower(20.0);
  return actor;
}

vtkSmartPointer<vtkActor> MakeColoredActor(
  vtkPolyData* surface, const std::string& array, vtkScalarsToColors* colors)
{
  vtkSmartPointer<vtkActor> actor = MakeActor(surface, { 1.0, 1.0, 1.0 });
  vtkMapper* mapper = actor->GetMapper();
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array.c_str());
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  // The ambient light is strong, so that colors in shade can be compared with the color bar.
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

vtkSmartPointer<vtkDataSet> AddGradient(vtkDataSet* data, const std::string& array)
{
  vtkNew<vtkGradientFilter> gradient;
  gradient->SetInputData(data);
  gradient->SetInputScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  gradient->SetResultArrayName(GRADIENT);
  gradient->Update();
  // vtkGradientFilter does not pass on the field data of structured datasets.
  gradient->GetOutput()->GetFieldData()->PassData(data->GetFieldData());
  return vtkDataSet::SafeDownCast(gradient->GetOutput());
}

vtkSmartPointer<vtkPolyData> MakeGridSurface(vtkStructuredGrid* grid, int axis, int index)
{
  int extent[6];
  grid->GetExtent(extent);
  extent[2 * axis] = index;
  extent[2 * axis + 1] = index;
  vtkNew<vtkStructuredGridGeometryFilter> geometry;
  geometry->SetInputData(grid);
  geometry->SetExtent(extent);
  geometry->Update();
  return MakeSurface(geometry->GetOutput());
}

vtkSmartPointer<vtkImageData> HideQuarter(vtkImageData* image, double x, double y)
{
  auto open = vtkSmartPointer<vtkImageData>::New();
  open->ShallowCopy(image);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    image->GetCellBounds(cell, bounds);
    const bool hidden = bounds[1] <= x && bounds[3] <= y;
    ghosts->SetValue(cell, hidden ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  open->GetCellData()->AddArray(ghosts);
  return open;
}

vtkSmartPointer<vtkImageData> Reduce(vtkImageData* image, int factor)
{
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(image);
  shrink->SetShrinkFactors(factor, factor, factor);
  shrink->MeanOn();
  shrink->Update();
  shrink->GetOutput()->GetPointData()->GetScalars()->SetName(
    image->GetPointData()->GetScalars()->GetName());
  return shrink->GetOutput();
}
}
