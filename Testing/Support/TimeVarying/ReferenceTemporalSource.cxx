// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkDataSet.h"
#include "vtkDeltaWingSource.h"
#include "vtkCell.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkTaperedCylinderSource.h"

namespace reference
{

namespace
{

template <typename Source>
TemporalSource Wrap(
  const std::string& name, const char* arrayName, const vtkSmartPointer<Source>& source)
{
  Source* s = source;
  return { name, source, [s](const double x[3], double t) { return s->Evaluate(x, t); },
    [s](int number) { s->SetNumberOfTimeSteps(number); }, [s] { return s->GetNumberOfTimeSteps(); },
    [s](double first, double last) { s->SetTimeRange(first, last); },
    [s] { return s->GetTimeRange(); }, [s](int type) { s->SetOutputScalarType(type); },
    [s] { return s->GetOutputScalarType(); }, [s](const char* n) { s->SetArrayName(n); },
    [s] { return std::string(s->GetArrayName()); }, arrayName };
}

}

vtkDataSet* TemporalSource::GetOutput() const
{
  return vtkDataSet::SafeDownCast(this->Algorithm->GetOutputDataObject(0));
}

vtkDataArray* TemporalSource::GetValues() const
{
  return this->GetOutput()->GetPointData()->GetScalars();
}

std::vector<TemporalSource> MakeTemporalSources()
{
  std::vector<TemporalSource> sources;
  for (int field = 0; field < vtkAnalyticFieldSource::NUMBER_OF_FIELDS; ++field)
  {
    auto image = vtkSmartPointer<vtkAnalyticFieldSource>::New();
    image->SetField(field);
    image->SetWholeExtent(-3, 14, 2, 17, 0, 12);
    sources.push_back(Wrap(vtkAnalyticFieldSource::GetFieldName(field), "f", image));
  }
  auto cylinder = vtkSmartPointer<vtkTaperedCylinderSource>::New();
  cylinder->SetDimensions(20, 16, 11);
  sources.push_back(Wrap("cylinder", "density", cylinder));
  auto wing = vtkSmartPointer<vtkDeltaWingSource>::New();
  wing->SetDimensions(17, 19, 12);
  sources.push_back(Wrap("wing", "loss", wing));
  return sources;
}

long long CountLeftHandedCells(vtkStructuredGrid* grid)
{
  // The neighbors of each corner of a hexahedron, in right-handed order. Corners 0 to 3 form the
  // bottom face, and corners 4 to 7 lie above them.
  constexpr int neighbors[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 }, { 7, 5, 0 },
    { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };
  long long number = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkPoints* points = grid->GetCell(cell)->GetPoints();
    bool isLeftHanded = false;
    for (int corner = 0; corner < 8; ++corner)
    {
      double from[3];
      double edges[3][3];
      points->GetPoint(corner, from);
      for (int edge = 0; edge < 3; ++edge)
      {
        points->GetPoint(neighbors[corner][edge], edges[edge]);
        vtkMath::Subtract(edges[edge], from, edges[edge]);
      }
      isLeftHanded = isLeftHanded || !(vtkMath::Determinant3x3(edges) > 0.0);
    }
    number += isLeftHanded;
  }
  return number;
}

}
