#include "vtkSimplexTimeSlice.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkExtractionArrays.h"
#include "vtkExtractionDispatch.h"
#include "vtkExtractionInput.h"
#include "vtkExtractionScalars.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSimplexSlicer.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

vtkStandardNewMacro(vtkSimplexTimeSlice);

namespace
{
constexpr const char* TimeName = "Time";

// Interpolated times would be off by a rounding, and float could not hold the time.
void FillTime(vtkPointData* points, vtkIdType number, double time)
{
  vtkNew<vtkDoubleArray> times;
  times->SetName(TimeName);
  times->SetNumberOfValues(number);
  vtkSMPTools::Fill(times->GetPointer(0), times->GetPointer(0) + number, time);
  // In the place of the array of that name, whatever role it has.
  points->AddArray(times);
}
}

vtkSimplexTimeSlice::vtkSimplexTimeSlice() = default;

vtkSimplexTimeSlice::~vtkSimplexTimeSlice() = default;

int vtkSimplexTimeSlice::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkSimplexTimeSlice::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkAbstractArray* array = input->GetPointData()->GetAbstractArray(TimeName);
  const std::string wrong = vtkExtractionInput::CheckScalars(
    input, array, vtkDataObject::FIELD_ASSOCIATION_POINTS, "point array \"Time\"");
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    return 1;
  }
  if (!std::isfinite(this->Time))
  {
    vtkErrorMacro("The time of the slice is " << this->Time << "; it has to be finite.");
    return 1;
  }
  const vtkExtractionValues values = vtkExtractionValues::ForContours({ this->Time });
  const vtkSmartPointer<vtkDataArray> times =
    vtkExtractionDispatch::MakeContiguous(vtkDataArray::SafeDownCast(array));
  vtkExtractionContext context;
  context.Owner = this;
  context.Values = &values;
  context.Input = input;
  context.Scalars = times;
  context.KeepCellIds = input->GetCellData()->GetNumberOfArrays() > 0;
  context.CellGhosts = input->GetCellGhostArray();
  context.PointGhosts = input->GetPointGhostArray();
  vtkSimplexSlicer::Slice slice;
  if (!vtkSimplexSlicer::Execute(context, input, slice))
  {
    return 1;
  }
  if (slice.WrongCell >= 0)
  {
    vtkErrorMacro(
      "Cell " << slice.WrongCell
              << " is no 4-simplex, which is a VTK_POLY_VERTEX of five points: it has type "
              << input->GetCellType(slice.WrongCell) << " and "
              << input->GetCells()->GetCellSize(slice.WrongCell) << " points.");
    return 1;
  }
  output->SetPoints(
    vtkExtractionArrays::MakePoints(input, slice.Points, vtkAlgorithm::DEFAULT_PRECISION));
  output->SetCells(VTK_TETRA, slice.Tetrahedra.MakeCells());
  this->UpdateProgress(0.85);
  vtkExtractionArrays::InterpolatePointData(
    input->GetPointData(), slice.Points, output->GetPointData());
  FillTime(output->GetPointData(), output->GetNumberOfPoints(), this->Time);
  this->UpdateProgress(0.95);
  vtkExtractionArrays::CopyCellData(input->GetCellData(), slice.CellIds.GetData(),
    static_cast<vtkIdType>(slice.CellIds.GetSize()), output->GetCellData());
  return 1;
}

void vtkSimplexTimeSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Time: " << this->Time << "\n";
}
