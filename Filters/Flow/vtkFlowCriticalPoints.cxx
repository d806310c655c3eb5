// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowCriticalPoints.h"

#include "Common/AbortCheck.h"
#include "Common/CellArrayConversion.h"
#include "Common/ReportValue.h"
#include "Fields/FieldVectors.h"
#include "Numerics/RealEigenvalues.h"
#include "Topology/ZeroSearch.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkFlowCriticalPoints);

namespace
{
// System of three equations: each vector component is 0.
class VectorSystem : public interlume::ZeroSearch::Systems
{
public:
  void GetRange(const interlume::MultilinearCell&, int& first, int& last) const override
  {
    first = 0;
    last = 1;
  }

  void Evaluate(const interlume::MultilinearCell& cell, int,
    interlume::MultilinearCell::Values& values) const override
  {
    std::copy_n(&cell.GetVectors()[0][0], 24, &values[0][0]);
  }
};

int Classify(const double eigenvalues[6])
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::max(largest, std::hypot(eigenvalues[2 * i], eigenvalues[2 * i + 1]));
  }
  const double threshold = 1e-9 * largest;
  int outgoing = 0;
  bool isSpiral = false;
  bool isDegenerate = false;
  bool isCenter = false;
  for (int i = 0; i < 3; ++i)
  {
    const bool isComplex = std::abs(eigenvalues[2 * i + 1]) > threshold;
    const bool isZero = std::abs(eigenvalues[2 * i]) <= threshold;
    outgoing += eigenvalues[2 * i] > 0.0 ? 1 : 0;
    isSpiral = isSpiral || isComplex;
    isDegenerate = isDegenerate || isZero;
    isCenter = isCenter || (isZero && isComplex);
  }
  if (isDegenerate)
  {
    return isCenter ? vtkFlowCriticalPoints::CENTER : vtkFlowCriticalPoints::DEGENERATE;
  }
  constexpr int types[4] = { vtkFlowCriticalPoints::SINK, vtkFlowCriticalPoints::SADDLE_2_IN,
    vtkFlowCriticalPoints::SADDLE_1_IN, vtkFlowCriticalPoints::SOURCE };
  return types[outgoing] + (isSpiral ? 1 : 0);
}

void SetPointsReport(vtkInterlumeReport* report, const interlume::ZeroSearch::Counts& counts = {},
  const std::vector<std::string>& converted = {})
{
  interlume::ReportValue::Set(report,
    { { "ZeroCells", counts.ZeroCells }, { "DegenerateCells", counts.DegenerateCells },
      { "NonFiniteCells", counts.NonFiniteCells }, { "FillValueCells", counts.FillValueCells },
      { "ConvertedCellArrays", converted } });
}
}

vtkFlowCriticalPoints::vtkFlowCriticalPoints()
{
  SetPointsReport(this->Report);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

vtkFlowCriticalPoints::~vtkFlowCriticalPoints() = default;

const char* vtkFlowCriticalPoints::GetTypeName(int type)
{
  static const char* const names[NUMBER_OF_TYPES] = { "degenerate", "source", "spiral source",
    "saddle, 1 in", "spiral saddle, 1 in", "saddle, 2 in", "spiral saddle, 2 in", "sink",
    "spiral sink", "center" };
  return type >= 0 && type < NUMBER_OF_TYPES ? names[type] : nullptr;
}

int vtkFlowCriticalPoints::FillInputPortInformation(int, vtkInformation* info)
{
  interlume::FieldVectors::FillPortInformation(info);
  return 1;
}

int vtkFlowCriticalPoints::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::CellArrayConversion::RequestGhostCells(this, inputs, outputs);
  return 1;
}

int vtkFlowCriticalPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  SetPointsReport(this->Report);
  interlume::CellArrayConversion conversion(this, 3);
  const auto selection = interlume::FieldVectors::Select(this, conversion, inputs, outputs);
  vtkDataSet* input = selection.Data;
  if (!input)
  {
    return 1;
  }
  this->SetProgressText("Searching cells for critical points");
  interlume::ZeroSearch search;
  if (!search.Execute(this, input, vtkDataArray::SafeDownCast(selection.Array), VectorSystem()))
  {
    return interlume::AbortCheck::Leave(outputs);
  }
  const interlume::ZeroSearch::Counts& counts = search.GetCounts();
  SetPointsReport(this->Report, counts, conversion.GetNames());

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> types;
  types->SetName("CriticalPointType");
  vtkNew<vtkDoubleArray> eigenvalues;
  eigenvalues->SetName("Eigenvalues");
  eigenvalues->SetNumberOfComponents(6);
  vtkNew<vtkDoubleArray> jacobians;
  jacobians->SetName("Jacobian");
  jacobians->SetNumberOfComponents(9);
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("CellLength");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("CellId");
  for (const interlume::ZeroSearch::Zero& zero : search.GetZeros())
  {
    const vtkIdType point = points->InsertNextPoint(zero.Position);
    vertices->InsertNextCell(1, &point);
    double values[6];
    interlume::RealEigenvalues::Compute(zero.Gradient, values);
    types->InsertNextValue(zero.IsDegenerate ? DEGENERATE : Classify(values));
    eigenvalues->InsertNextTuple(values);
    jacobians->InsertNextTuple(zero.Gradient);
    lengths->InsertNextValue(zero.CellLength);
    cells->InsertNextValue(zero.Cell);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  data->SetScalars(types);
  data->AddArray(eigenvalues);
  data->AddArray(jacobians);
  data->AddArray(lengths);
  data->AddArray(cells);
  if (points->GetNumberOfPoints() == 0)
  {
    vtkWarningMacro("The field has no isolated critical point in any of its "
      << input->GetNumberOfCells() << " cells. The velocity is 0 throughout " << counts.ZeroCells
      << " cells, 0 along lines or surfaces in " << counts.DegenerateCells << ", not finite in "
      << counts.NonFiniteCells << ", and a fill value in " << counts.FillValueCells << ".");
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkFlowCriticalPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
