// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractionReport.h"

#include "Common/NamedValue.h"

#include <algorithm>
#include <ostream>

void vtkExtractionReport::Add(const vtkExtractionReport& other)
{
  this->Cells += other.Cells;
  this->CellsVisited += other.CellsVisited;
  this->CellsWithOutput += other.CellsWithOutput;
  this->LowerDimensionalCells += other.LowerDimensionalCells;
  this->NonFiniteCells += other.NonFiniteCells;
  this->BlankedCells += other.BlankedCells;
  this->LinearizedCells += other.LinearizedCells;
  this->ConcavePolyhedra += other.ConcavePolyhedra;
  this->UnsupportedCells += other.UnsupportedCells;
  this->CollapsedSimplices += other.CollapsedSimplices;
  this->WholeCells += other.WholeCells;
  this->WarpedFaces += other.WarpedFaces;
  this->ArraysInterpolated = std::max(this->ArraysInterpolated, other.ArraysInterpolated);
  this->ArraysCopied = std::max(this->ArraysCopied, other.ArraysCopied);
  this->Passes = std::max(this->Passes, other.Passes);
  this->WorkingBytes = std::max(this->WorkingBytes, other.WorkingBytes);
}

void vtkExtractionReport::Print(ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Cells", this->Cells }, { "CellsVisited", this->CellsVisited },
      { "CellsWithOutput", this->CellsWithOutput },
      { "LowerDimensionalCells", this->LowerDimensionalCells },
      { "NonFiniteCells", this->NonFiniteCells }, { "BlankedCells", this->BlankedCells },
      { "LinearizedCells", this->LinearizedCells }, { "ConcavePolyhedra", this->ConcavePolyhedra },
      { "UnsupportedCells", this->UnsupportedCells },
      { "CollapsedSimplices", this->CollapsedSimplices }, { "WholeCells", this->WholeCells },
      { "WarpedFaces", this->WarpedFaces }, { "ArraysInterpolated", this->ArraysInterpolated },
      { "ArraysCopied", this->ArraysCopied }, { "Passes", this->Passes },
      { "WorkingBytes", this->WorkingBytes } });
}
