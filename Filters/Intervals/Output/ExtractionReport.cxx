// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExtractionReport.h"

#include "Common/ReportValue.h"

#include <algorithm>
#include <numeric>

namespace interlume
{

double ExtractionReport::GetBalance() const
{
  const std::vector<vtkIdType>& cells = this->CellsPerProcess;
  const double sum = std::accumulate(cells.begin(), cells.end(), 0.0);
  return sum > 0.0 ? static_cast<double>(*std::max_element(cells.begin(), cells.end())) *
      static_cast<double>(cells.size()) / sum
                   : 0.0;
}

void ExtractionReport::Add(const ExtractionReport& other)
{
  this->Cells += other.Cells;
  this->CellsVisited += other.CellsVisited;
  this->CellsByBits += other.CellsByBits;
  this->CellsWithOutput += other.CellsWithOutput;
  this->LowerDimensionalCells += other.LowerDimensionalCells;
  this->NonFiniteCells += other.NonFiniteCells;
  this->BlankedCells += other.BlankedCells;
  this->LinearizedCells += other.LinearizedCells;
  this->ConcavePolyhedra += other.ConcavePolyhedra;
  this->UnsupportedCells += other.UnsupportedCells;
  this->FoldedCells += other.FoldedCells;
  this->CoveredCells += other.CoveredCells;
  this->LevelFaces += other.LevelFaces;
  this->CollapsedSimplices += other.CollapsedSimplices;
  this->InteriorCells += other.InteriorCells;
  this->NonPlanarFaces += other.NonPlanarFaces;
  this->ArraysInterpolated = std::max(this->ArraysInterpolated, other.ArraysInterpolated);
  this->ArraysCopied = std::max(this->ArraysCopied, other.ArraysCopied);
  this->Passes = std::max(this->Passes, other.Passes);
  this->WorkingBytes = std::max(this->WorkingBytes, other.WorkingBytes);
  this->ReusedBytes = std::max(this->ReusedBytes, other.ReusedBytes);
  this->IdleBytes = std::max(this->IdleBytes, other.IdleBytes);
}

void ExtractionReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "Cells", this->Cells }, { "CellsVisited", this->CellsVisited },
      { "CellsByBits", this->CellsByBits }, { "CellsWithOutput", this->CellsWithOutput },
      { "LowerDimensionalCells", this->LowerDimensionalCells },
      { "NonFiniteCells", this->NonFiniteCells }, { "BlankedCells", this->BlankedCells },
      { "LinearizedCells", this->LinearizedCells }, { "ConcavePolyhedra", this->ConcavePolyhedra },
      { "UnsupportedCells", this->UnsupportedCells }, { "FoldedCells", this->FoldedCells },
      { "CoveredCells", this->CoveredCells }, { "LevelFaces", this->LevelFaces },
      { "CollapsedSimplices", this->CollapsedSimplices }, { "InteriorCells", this->InteriorCells },
      { "NonPlanarFaces", this->NonPlanarFaces },
      { "ArraysInterpolated", this->ArraysInterpolated }, { "ArraysCopied", this->ArraysCopied },
      { "Passes", this->Passes }, { "WorkingBytes", this->WorkingBytes },
      { "ReusedBytes", this->ReusedBytes }, { "IdleBytes", this->IdleBytes },
      { "CellsPerProcess", this->CellsPerProcess }, { "Balance", this->GetBalance() },
      { "ConvertedCellArrays", this->ConvertedCellArrays } });
}

}
