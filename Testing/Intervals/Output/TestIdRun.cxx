// SPDX-License-Identifier: BSD-3-Clause
// Ids of cells along a row and multiples, in the cache and past it, against what is asked of each
// one; points that stay against a loop over their marks; and the volume of so many tetrahedra that
// they are written past the cache.
#include "Support/Checks/ReferenceCheck.h"

#include "Output/IdRun.h"
#include "Output/KeptRuns.h"

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
using interlume::IdRun;
using Id = vtkTypeInt32;

/// Four ids, so that the first of a vector of them is where streams may begin.
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
  isStreamed ? IdRun::Stream(ids + number, number, cells)
             : IdRun::Write(ids + number, number, cells);
  for (vtkIdType at = number; at < number * (cells + 1); ++at)
  {
    check.Equal(ids[at], ids[at % number] + at / number, "id " + std::to_string(at));
  }
  check.Equal(ids[number * (cells + 1)], Untouched, "what follows");
}

void CheckMultiples(vtkIdType first, vtkIdType last, bool isStreamed, Check& check)
{
  check.SetContext("multiples of [" + std::to_string(first) + ", " + std::to_string(last) + ")" +
    (isStreamed ? " streamed" : ""));
  std::vector<Id> values(last + 1, Untouched);
  IdRun::FillMultiples(values.data(), 3, first, last, isStreamed);
  for (vtkIdType i = 0; i <= last; ++i)
  {
    check.Equal(values[i], i < first || i == last ? Untouched : 3 * i, std::to_string(i));
  }
}

void CheckPoints(int number, int kept, std::mt19937& random, Check& check)
{
  check.SetContext(std::to_string(number) + " points of which stay " + std::to_string(kept) + "/8");
  std::vector<unsigned char> marks;
  std::vector<vtkIdType> removed;
  std::vector<int> values;
  std::vector<int> expected;
  for (int p = 0; p < number; ++p)
  {
    marks.push_back(static_cast<int>(random() % 8) < kept);
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
  const interlume::KeptRuns runs(marks.data(), number);
  check.Equal(2 * runs.GetNumber(), expected.size(), "values that stay");
  std::vector<vtkIdType> ids(number, -1);
  runs.FillIds(ids.data());
  vtkIdType next = 0;
  check.That(std::equal(ids.begin(), ids.end(), marks.begin(),
               [&next](vtkIdType id, unsigned char mark) { return id == (mark ? next++ : -1); }),
    "new ids");
  const interlume::KeptRuns others(removed, number);
  for (const vtkIdType parts : { 1, 2, 3, 7 })
  {
    for (const char* backend : { "Sequential", "STDThread" })
    {
      std::vector<int> compacted = values;
      const interlume::KeptRuns* kept = parts % 2 == 0 ? &runs : &others;
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, backend, false },
        [&]() { kept->Compact(compacted.data(), 2, parts); });
      compacted.resize(expected.size());
      check.That(compacted == expected, "values that stay, in order, " + std::to_string(parts));
    }
  }
}

/// A slab of a ramp along i; its tetrahedra are more than are kept in a cache.
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
  check.Equal(IdRun::IsStreamed(ids, output->GetNumberOfCells()),
    IdRun::IsStreamed(aligned.Ids, vtkIdType(1) << 31), "written past the cache, where it can be");
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
  check.Equal(inverted, 0, "tetrahedra without volume");
  check.Near(sum, (points - 2.0) * (points - 1.0) * (points - 1.0), 1e-6, "volume");
}

}

int TestIdRun(int, char*[])
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
  for (const int kept : { 0, 1, 4, 7, 8 })
  {
    CheckPoints(1, kept, random, check);
    CheckPoints(500, kept, random, check);
    // So many that several threads move them at once.
    CheckPoints(400000, kept, random, check);
  }
  CheckVolume(check);
  return check.Result();
}
