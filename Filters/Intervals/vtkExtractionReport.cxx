// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractionReport.h"

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
  this->ArraysInterpolated = std::max(this->ArraysInterpolated, other.ArraysInterpolated);
  this->ArraysCopied = std::max(this->ArraysCopied, other.ArraysCopied);
  this->Passes = std::max(this->Passes, other.Passes);
  this->WorkingBytes = std::max(this->WorkingBytes, other.WorkingBytes);
}

void vtkExtractionReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "Cells: " << this->Cells << "\n";
  os << indent << "CellsVisited: " << this->CellsVisited << "\n";
  os << indent << "CellsWithOutput: " << this->CellsWithOutput << "\n";
  os << indent << "LowerDimensionalCells: " << this->LowerDimensionalCells << "\n";
  os << indent << "NonFiniteCells: " << this->NonFiniteCells << "\n";
  os << indent << "BlankedCells: " << this->BlankedCells << "\n";
  os << indent << "LinearizedCells: " << this->LinearizedCells << "\n";
  os << indent << "ConcavePolyhedra: " << this->ConcavePolyhedra << "\n";
  os << indent << "UnsupportedCells: " << this->UnsupportedCells << "\n";
  os << indent << "CollapsedSimplices: " << this->CollapsedSimplices << "\n";
  os << indent << "ArraysInterpolated: " << this->ArraysInterpolated << "\n";
  os << indent << "ArraysCopied: " << this->ArraysCopied << "\n";
  os << indent << "Passes: " << this->Passes << "\n";
  os << indent << "WorkingBytes: " << this->WorkingBytes << "\n";
}
