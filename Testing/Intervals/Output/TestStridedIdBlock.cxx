// SPDX-License-Identifier: BSD-3-Clause
// Cell ids along a row and their multiples, written with normal and with streaming stores, compared
// with scalar loops. Also tests the compaction of retained points, compared with a loop over the
// marks, and a volume with enough tetrahedra to use streaming stores.
#include "Support/Checks/ReferenceCheck.h"

#include "Output/StridedIdBlock.h"
#include "Output/RetainedIdRanges.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using interlume::StridedIdBlock;
using Id = vtkTypeInt32;

/// Four point ids, aligned so that streaming stores can start at every tetrahedron.
struct alignas(16) Tetrahedron
{
  Id Ids[4];
};

constexpr Id Untouched = -7;

void CheckRun(int tetrahedra, vtkIdType cells, bool isStreamed, std::mt19937& random, Check& check)
{
  check.SetContext(std::to_string(cells) + " cells of " + std::to_string(tetrahedra) +
    (isStreamed ? " streamed" : ""));
  const int number = 4 * tetrahedra;
  std::vector<Tetrahedron> memory(
    tetrahedra * (cells + 1) + 1, { { Untouched, Untouched, Untouched, Untouched } });
  Id* const ids = memory[0].Ids;
  for (int i = 0; i < number; ++i)
  {
    ids[i] = static_cast<Id>(random() % 1000000);
  }
  isStreamed ? StridedIdBlock::Stream(ids + number, number, cells)
             : StridedIdBlock::Write(ids + number, number, cells);
  for (vtkIdType at = number; at < number * (cells + 1); ++at)
  {
    check.Equal(ids[at], ids[at % number] + at / number, "id " + std::to_string(at));
  }
  check.Equal(ids[number * (cells + 1)], Untouched, "memory after the block is unchanged");
}

void CheckMultiples(vtkIdType first, vtkIdType last, bool isStreamed, Check& check)
{
  check.SetContext("multiples of [" + std::to_string(first) + ", " + std::to_string(last) + ")" +
    (isStreamed ? " streamed" : ""));
  std::vector<Id> values(last + 1, Untouched);
  StridedIdBlock::FillMultiples(values.data(), 3, first, last, isStreamed);
  for (vtkIdType i = 0; i <= last; ++i)
  {
    check.Equal(values[i], i < first || i == last ? Untouched : 3 * i, std::to_string(i));
  }
}

void CheckPoints(int number, int retained, std::mt19937& random, Check& check)
{
  check.SetContext(
    std::to_string(number) + " points, retained: " + std::to_string(retained) + "/8");
  std::vector<unsigned char> marks;
  std::vector<vtkIdType> removed;
  std::vector<int> values;
  std::vector<int> expected;
  for (int p = 0; p < number; ++p)
  {
    marks.push_back(static_cast<int>(random() % 8) < retained);
    values.insert(values.end(), { 2 * p, 2 * p + 1 });
    if (marks.back())
    {
      expected.insert(expected.end(), { 2 * p, 2 * p + 1 });
    }
    else
    {
      removed.push_back(p);
    }
  }
  const interlume::RetainedIdRanges runs(marks.data(), number);
  check.Equal(2 * runs.GetNumber(), expected.size(), "number of retained values");
  std::vector<vtkIdType> ids(number, -1);
  runs.FillIds(ids.data());
  vtkIdType next = 0;
  check.That(std::equal(ids.begin(), ids.end(), marks.begin(),
               [&next](vtkIdType id, unsigned char mark) { return id == (mark ? next++ : -1); }),
    "new ids");
  const interlume::RetainedIdRanges others(removed, number);
  for (const vtkIdType parts : { 1, 2, 3, 7 })
  {
    for (const char* backend : { "Sequential", "STDThread" })
    {
      std::vector<int> compacted = values;
      const interlume::RetainedIdRanges* retained = parts % 2 == 0 ? &runs : &others;
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, backend, false },
        [&]() { retained->Compact(compacted.data(), 2, parts); });
      compacted.resize(expected.size());
      check.That(compacted == expected, "retained values, in order, " + std::to_string(parts));
    }
  }
}

/// Extracts a slab from a ramp along i, with enough tetrahedra to use streaming stores.
void CheckVolume(Check& check)
{
  check.SetContext("volume");
  constexpr int points = 82;
  vtkNew<vtkImageData> image;
  image->SetDimensions(points, points, points);
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetName("ramp");
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    ramp->InsertNextValue(static_cast<double>(p % points));
  }
  image->GetPointData()->SetScalars(ramp);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetNumberOfIntervals(1);
  filter->SetInterval(0, 0.5, points - 1.5);
  filter->Update();
  vtkUnstructuredGrid* const output = filter->GetOutput();
  const Id* const ids =
    static_cast<const Id*>(output->GetCells()->GetConnectivityArray()->GetVoidPointer(0));
  const Tetrahedron aligned{};
  check.Equal(StridedIdBlock::ShouldStream(ids, output->GetNumberOfCells()),
    StridedIdBlock::ShouldStream(aligned.Ids, vtkIdType(1) << 31),
    "streaming stores are used if supported");
  double sum = 0.0;
  vtkIdType inverted = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    double x[4][3];
    for (int p = 0; p < 4; ++p)
    {
      output->GetPoints()->GetPoint(ids[4 * cell + p], x[p]);
    }
    const double volume = vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]);
    inverted += volume <= 0.0;
    sum += volume;
  }
  check.Equal(inverted, 0, "degenerate tetrahedra");
  check.Near(sum, (points - 2.0) * (points - 1.0) * (points - 1.0), 1e-6, "volume");
}

}

int TestStridedIdBlock(int, char*[])
{
  Check check;
  std::mt19937 random(5);
  for (const bool isStreamed : { false, true })
  {
    for (const int tetrahedra : { 1, 5, 6, 16, 17 })
    {
      for (const vtkIdType cells : { 1, 4, 33 })
      {
        CheckRun(tetrahedra, cells, isStreamed, random, check);
      }
    }
    for (const vtkIdType first : { 0, 1, 3, 4, 6 })
    {
      for (const vtkIdType last : { 6, 7, 8, 33 })
      {
        CheckMultiples(first, last, isStreamed, check);
      }
    }
  }
  for (const int retained : { 0, 1, 4, 7, 8 })
  {
    CheckPoints(1, retained, random, check);
    CheckPoints(500, retained, random, check);
    // Enough values for several threads.
    CheckPoints(400000, retained, random, check);
  }
  CheckVolume(check);
  return check.Result();
}
