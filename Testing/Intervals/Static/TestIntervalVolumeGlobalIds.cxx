// SPDX-License-Identifier: BSD-3-Clause
// Two blocks with different point orders cut their common faces in the same way if they have global
// ids, of any integer type. Invalid ids are an error.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceBlocks.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{

using namespace reference;

constexpr unsigned int Orders = 6;
const std::vector<Interval> Intervals = { { -1.0, 0.5 } };

/// A cell type, and the axis perpendicular to the face between the blocks.
struct Form
{
  MeshKind Kind;
  int Axis;
};

const Form Forms[] = { { MeshKind::Hexahedra, 0 }, { MeshKind::Wedges, 0 }, { MeshKind::Boxes, 1 },
  { MeshKind::Mixed, 2 }, { MeshKind::Honeycomb, 2 } };

using Extract = std::function<vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*)>;

vtkSmartPointer<vtkUnstructuredGrid> ExtractStatic(vtkUnstructuredGrid* block)
{
  return ExtractIntervals(block, Intervals).Volume;
}

vtkSmartPointer<vtkUnstructuredGrid> ExtractInTime(vtkUnstructuredGrid* block)
{
  return ExtractTimeVarying(RepeatGrid(block, { 0.0, 1.0 }), { Intervals }).Simplices;
}

/// Returns the number of point orders for which the common faces of the two blocks differ.
int CountDifferent(const Form& form, const IdStorage& ids, const Extract& extract, Check& check)
{
  int different = 0;
  for (unsigned int seed = 1; seed <= Orders; ++seed)
  {
    const auto blocks = MakeBlocks(form.Kind, form.Axis, seed, ids);
    const auto faces = FacesBetweenBlocks(extract(blocks[0]), form.Axis);
    check.That(!faces.empty(), "there are common faces");
    different += faces != FacesBetweenBlocks(extract(blocks[1]), form.Axis);
  }
  return different;
}

void CheckTypes(const std::string& name, const Extract& extract, Check& check)
{
  for (const Form& form : Forms)
  {
    check.SetContext(name + ", " + GetName(form.Kind));
    check.That(CountDifferent(form, { VTK_VOID, false }, extract, check) > 0,
      "without ids, faces differ for some point orders");
    for (const IdStorage& ids : AllIdStorages())
    {
      check.Equal(CountDifferent(form, ids, extract, check), 0,
        "point orders with different faces, ids of type " + std::to_string(ids.Type) +
          (ids.IsInColumns ? " in columns" : ""));
    }
  }
}

void ExpectError(vtkDataArray* ids, const std::string& part, Check& check)
{
  const auto block = MakeBlocks(MeshKind::Hexahedra, 0, 1, { VTK_VOID, false })[0];
  ids->SetName("numbers");
  block->GetPointData()->SetGlobalIds(ids);
  ids->SetNumberOfComponents(part.find("component") == std::string::npos ? 1 : 2);
  vtkNew<vtkIntervalVolume> volume;
  vtkNew<vtkIsotableContour> contour;
  volume->SetInterval(0, -1.0, 0.5);
  contour->SetValue(0, 0.5);
  const TimeVaryingPipeline pipeline(RepeatGrid(block, { 0.0, 1.0 }), { Intervals });
  volume->SetInputData(block);
  contour->SetInputData(block);
  for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(volume),
         static_cast<vtkAlgorithm*>(contour), static_cast<vtkAlgorithm*>(pipeline.Filter) })
  {
    const std::string message = UpdateAndGetErrors(filter);
    check.That(message.find("global ids") != std::string::npos &&
        message.find("\"numbers\" " + part) != std::string::npos,
      std::string(filter->GetClassName()) + " reports: " + message);
    check.Equal(
      vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), 0,
      "the output is empty");
  }
}

void CheckErrors(Check& check)
{
  check.SetContext("invalid ids");
  constexpr vtkIdType points = 18;
  vtkNew<vtkIdTypeArray> shorter;
  shorter->SetNumberOfTuples(points - 1);
  shorter->Fill(0);
  ExpectError(shorter, "has 17 tuples; 18 are needed", check);
  vtkNew<vtkIdTypeArray> twice;
  twice->SetNumberOfTuples(2 * points);
  twice->Fill(0);
  ExpectError(twice, "has 2 components; 1 is needed", check);
  vtkNew<vtkFloatArray> floats;
  floats->SetNumberOfTuples(points);
  floats->Fill(0);
  ExpectError(floats, "is a vtkFloatArray; integers are needed", check);
  vtkNew<vtkDoubleArray> doubles;
  doubles->SetNumberOfTuples(points);
  doubles->Fill(0);
  ExpectError(doubles, "is a vtkDoubleArray; integers are needed", check);
}

}

int TestIntervalVolumeGlobalIds(int, char*[])
{
  Check check;
  CheckTypes("intervals", ExtractStatic, check);
  CheckTypes("intervals in time", ExtractInTime, check);
  CheckErrors(check);
  return check.Result();
}
