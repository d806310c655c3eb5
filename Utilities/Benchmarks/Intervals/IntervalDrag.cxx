// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkIntervalVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageResample.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace interval
{
namespace
{
/// Position of a dragged bound, as a fraction of the scalar range.
struct BoundPosition
{
  const char* Name;
  double Fraction;
};

constexpr BoundPosition Positions[] = { { "low", 0.1 }, { "middle", 0.5 }, { "high", 0.9 } };

struct DragCase
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
};

/// Returns CT scans with 256^3 points: a bonsai, and a head resampled by linear interpolation. If
/// \a options do not request full size, returns the wavelet instead.
std::vector<DragCase> MakeCases(const BenchOptions& options)
{
  if (options.Size != BenchOptions::FULL)
  {
    const BenchData wavelet = MakeWavelet(GetWaveletResolution(options));
    return { { wavelet.Case, vtkImageData::SafeDownCast(wavelet.Data) } };
  }
  std::vector<DragCase> cases;
  cases.push_back({ "bonsai",
    vtkImageData::SafeDownCast(CopyWithOneArray(interlume::ReadData("bonsai.vti"), "ImageFile")) });
  const auto head = CopyWithOneArray(interlume::ReadData("headsq_quarter.vti"), "density");
  int dimensions[3];
  vtkImageData::SafeDownCast(head)->GetDimensions(dimensions);
  vtkNew<vtkImageResample> resample;
  resample->SetInputData(head);
  resample->SetInterpolationModeToLinear();
  for (int axis = 0; axis < 3; ++axis)
  {
    resample->SetAxisMagnificationFactor(axis, 256.0 / dimensions[axis]);
  }
  resample->Update();
  cases.push_back({ "head-ct-256", resample->GetOutput() });
  return cases;
}

/// Returns the number of cells whose scalar range intersects [first, second].
vtkIdType CountCells(vtkImageData* image, double first, double second)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const vtkIdType row = dimensions[0];
  const vtkIdType layer = row * dimensions[1];
  // -1 for values below first, 1 for values above second, 0 otherwise.
  std::vector<signed char> sides(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const double value = scalars->GetComponent(static_cast<vtkIdType>(i), 0);
    sides[i] = static_cast<signed char>((value > second) - (value < first));
  }
  vtkIdType number = 0;
  for (int k = 0; k + 1 < dimensions[2]; ++k)
  {
    for (int j = 0; j + 1 < dimensions[1]; ++j)
    {
      for (int i = 0; i + 1 < dimensions[0]; ++i)
      {
        const signed char* corner = sides.data() + k * layer + j * row + i;
        int lowest = 1;
        int highest = -1;
        for (const vtkIdType step : { vtkIdType(0), row, layer, layer + row })
        {
          lowest = std::min<int>({ lowest, corner[step], corner[step + 1] });
          highest = std::max<int>({ highest, corner[step], corner[step + 1] });
        }
        number += lowest <= 0 && highest >= 0;
      }
    }
  }
  return number;
}

/// A filter whose lower bound moves up and down by a constant step between updates.
class Drag
{
public:
  Drag(vtkImageData* image, double first, double step, double upper, bool reusesMemory)
    : Filter(methods::NewIntervalVolume(image, first, upper))
    , First(first)
    , Step(step)
    , Upper(upper)
  {
    this->Filter->SetReuseMemory(reusesMemory);
    this->Filter->Update();
  }

  vtkSmartPointer<vtkObjectBase> Move()
  {
    constexpr int multiples[] = { 1, 2, 3, 2, 1, 0 };
    this->Filter->SetInterval(
      0, this->First + this->Step * multiples[this->Run++ % 6], this->Upper);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  vtkSmartPointer<vtkIntervalVolume> Filter;

private:
  double First;
  double Step;
  double Upper;
  int Run = 0;
};

void AddDragRow(const DragCase& one, const BoundPosition& position, bool isTied, int threads,
  const BenchOptions& options, BenchRows& rows)
{
  double range[2];
  one.Image->GetPointData()->GetScalars()->GetRange(range);
  const double length = range[1] - range[0];
  const double at = std::floor(range[0] + position.Fraction * length);
  const double first = isTied ? at : at + 0.4;
  const double step = isTied ? std::max(std::floor(length / 200), 1.0) : length / 200;
  const double upper = isTied ? range[1] : range[1] + 0.5;
  Drag reused(one.Image, first, step, upper, true);
  Drag plain(one.Image, first, step, upper, false);
  const std::size_t kib = reused.Filter->GetOutput()->GetActualMemorySize();
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(threads, [&]() { return reused.Move(); }),
                         WithThreads(threads, [&]() { return plain.Move(); }) },
      options.GetRepeats());

  const auto count = [&reused](const char* name)
  { return reused.Filter->GetReport()->GetCount(name); };
  const vtkIdType changed = CountCells(one.Image, first + step, first + 2 * step);
  BenchRow row = rows.Make(
    one.Name + "-" + position.Name, isTied ? "drag-tied" : "drag", ThreadsParameter(threads));
  row.SetTimes(seconds[0], "new-memory", seconds[1]);
  row.Set({ { "threads", threads }, { "cells", count("Cells") }, { "changed", changed },
    { "share", static_cast<double>(changed) / static_cast<double>(count("Cells")) },
    { "with_output", count("CellsWithOutput") },
    { "tetrahedra", reused.Filter->GetOutput()->GetNumberOfCells() }, { "output_kib", kib },
    { "reused_kib", count("ReusedBytes") / 1024 }, { "idle_kib", count("IdleBytes") / 1024 } });
  rows.Add(row);
}

/**
 * Measures updates after small changes of a bound, with one thread and with all threads. The lower
 * bound moves by 1/200 of the scalar range between updates, in the low, middle or high part of the
 * range. Methods: `drag`, with bounds between the scalars, and `drag-tied`, with bounds that equal
 * scalars. ReuseMemory is on; the baseline `new-memory` has it off. The count `changed` is the
 * number of cells whose scalar range intersects the interval that the bound passes between two
 * updates, and `share` is their fraction of all cells. Other counts are the size of the output and
 * the reused and idle memory.
 */
void AddDragRows(const BenchOptions& options, BenchRows& rows)
{
  for (const DragCase& one : MakeCases(options))
  {
    for (const BoundPosition& position : Positions)
    {
      for (const int threads : options.GetThreadCounts())
      {
        for (const bool isTied : { false, true })
        {
          AddDragRow(one, position, isTied, threads, options, rows);
        }
      }
    }
  }
}
}

BenchPart MakeDragPart()
{
  const auto dragged = [](const BenchRow& row)
  {
    const bool counts = row.Method.rfind("drag", 0) == 0 && row.Counts.value("threads", 1) > 1 &&
      row.Counts.value("share", 1.0) < 0.1;
    return counts ? std::optional<double>(*row.Seconds) : std::nullopt;
  };
  const auto check = [dragged](const std::vector<BenchRow>& rows) -> std::vector<BenchClaim>
  {
    return { BenchClaim::AtMost("2 threads, a dragged bound, where less than a tenth of the cells "
                                "changes: at most 0.1 s an update",
      0.1, rows, dragged) };
  };
  return { AddDragRows, nullptr, check };
}
}
