// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/Interval4dCounts.h"

#include "Benchmarks/Data/CellSplits.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace interval4d
{
namespace
{
const char* const Hexahedra = "hexahedra";
const char* const Tetrahedra = "tetrahedra-5";
const char* const Classes[] = { "1", "2", "3a", "3b", "4", "5" };

/// What the source counted; 0 for 3-simplices that it does not tell.
struct Stated
{
  const char* Case;
  const char* Method;
  vtkIdType InSpace;
  vtkIdType InTime;
  std::array<vtkIdType, 6> OfClass;
};

const Stated Source[] = {
  { "vortex-2", Hexahedra, 62636, 319304, { { 237606, 0, 455712, 6, 45990, 142730 } } },
  { "vortex-2", Tetrahedra, 78678, 344853, { { 82542, 0, 56432, 16371, 85890, 267574 } } },
  { "wave-2", Hexahedra, 0, 82840, { { 61104, 0, 128744, 0, 8816, 36062 } } },
  { "wave-2", Tetrahedra, 0, 87970, { { 17934, 0, 16896, 4794, 19992, 68704 } } },
};

/// The same steps with every cell of the image cut into five.
Case CutIntoFive(const Case& what)
{
  Case cut = what;
  cut.Steps = vtkSmartPointer<KeptTimeSteps>::New();
  // The cells are those of every step; the points keep their numbers.
  const auto grid = SplitIntoTetrahedra(vtkImageData::SafeDownCast(what.Steps->GetStep(0)), 5);
  for (int step = 0; step < what.Steps->GetNumberOfSteps(); ++step)
  {
    auto* image = vtkImageData::SafeDownCast(what.Steps->GetStep(step));
    grid->GetPointData()->ShallowCopy(image->GetPointData());
    cut.Steps->AddStep(what.Steps->GetTimeOf(step), grid);
  }
  return cut;
}

void AddRow(const Case& what, const char* method, BenchRows& rows)
{
  auto filter = what.NewFilter();
  filter->Update();
  const vtkTimeVaryingReport& report = filter->GetReport();
  BenchRow row = rows.Make(what.Name, method);
  row.Counts["3_simplices"] = methods::IntervalVolume(
    vtkDataSet::SafeDownCast(what.Steps->GetStep(0)), what.Lower, what.Upper)
                                ->GetNumberOfCells();
  row.Counts["4_simplices"] = report.Simplices;
  row.Counts["flat"] = report.FlatSimplices;
  row.Counts["inverted"] = report.InvertedSimplices;
  row.Counts["tetrahedra"] = filter->GetOutput()->GetNumberOfCells();
  for (std::size_t i = 0; i < report.Tetrahedra.size(); ++i)
  {
    row.Counts[std::string("class_") + Classes[i]] = report.Tetrahedra[i];
  }
  for (const Stated& stated : Source)
  {
    if (what.Stated && what.Name == stated.Case && std::string(method) == stated.Method)
    {
      if (stated.InSpace > 0)
      {
        row.Counts["stated_3_simplices"] = stated.InSpace;
      }
      row.Counts["stated_4_simplices"] = stated.InTime;
      for (std::size_t i = 0; i < stated.OfClass.size(); ++i)
      {
        row.Counts[std::string("stated_class_") + Classes[i]] = stated.OfClass[i];
      }
    }
  }
  rows.Add(row);
}

/// A count of the row of the same case by the other method, divided by this row's.
std::function<std::optional<double>(const BenchRow&)> HexahedraOverTetrahedra(
  const char* count, const std::vector<BenchRow>& rows)
{
  return [count, &rows](const BenchRow& row) -> std::optional<double>
  {
    if (row.Method != Hexahedra)
    {
      return std::nullopt;
    }
    for (const BenchRow& other : rows)
    {
      if (other.Method == Tetrahedra && other.Case == row.Case)
      {
        return row.Counts[count].get<double>() / other.Counts[count].get<double>();
      }
    }
    return std::nullopt;
  };
}
}

void AddCountRows(const BenchOptions& options, BenchRows& rows)
{
  // Ten million tetrahedra are too many for a quick look.
  const std::string vortex = options.Pick<std::string>("vortex-2", "vortex-3", "vortex-3");
  for (const std::string& name : { vortex, std::string("wave-2") })
  {
    const Case what = MakeCase(name, options);
    AddRow(what, Hexahedra, rows);
    AddRow(CutIntoFive(what), Tetrahedra, rows);
  }
}

std::vector<BenchClaim> CheckCountClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("hexahedra along t: no tetrahedra of class 2", 0.0, rows,
             CountOf(Hexahedra, "class_2")),
    BenchClaim::AtMost("4-simplices of hexahedra for one of tetrahedra: at most 1", 1.0, rows,
      HexahedraOverTetrahedra("4_simplices", rows)),
    BenchClaim::AtMost("tetrahedra of hexahedra for one of tetrahedra: at most 2", 2.0, rows,
      HexahedraOverTetrahedra("tetrahedra", rows)) };
}
}
