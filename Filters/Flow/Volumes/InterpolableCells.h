// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InterpolableCells_h
#define interlume_InterpolableCells_h

#include "vtkType.h"

#include <array>
#include <map>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;

namespace interlume
{

class ImplicitFlowArrays;

/**
 * @class   InterpolableCells
 * @brief   classifies cells of an implicit flow field by whether values can be interpolated inside
 * them
 *
 * If the parameters of a cell's corners differ by more than half a period, the corners are on both
 * sides of a seam. The parameters are unwrapped by adding a period to values below one half.
 * ImplicitFlowArrays::IsAcrossSurface() determines whether a surface crosses a cell.
 */
class InterpolableCells
{
public:
  /// Properties of a cell, as bits.
  enum Kinds : unsigned char
  {
    ACROSS_U = 1,
    ACROSS_V = 2,
    ACROSS = ACROSS_U | ACROSS_V,
    /// The cell is excluded for one of the following reasons.
    WITHOUT_RESULT = 4,
    BETWEEN_SURFACES = 8,
    ON_SEAM = 16,
    ACROSS_SURFACE = 64,
    TIME_JUMP = 128,
    EXCLUDED = WITHOUT_RESULT | BETWEEN_SURFACES | ON_SEAM | ACROSS_SURFACE | TIME_JUMP,
    /// The cell crosses a seam, and its corners cannot be unwrapped to within half a period.
    AROUND_POLE = 32
  };

  /// Whether u and v are continuous across their seams, by surface id.
  using Continuity = std::map<int, std::array<bool, 2>>;

  /// Limits of interpolation.
  struct Limits
  {
    Continuity Seams;
    /// Largest difference between the times of a cell's corners; 0 for no limit.
    double MaximumTimeJump = 0.0;
  };

  /// Classifies all cells of \a data. Returns false if \a owner was aborted.
  bool Find(vtkDataSet* data, const ImplicitFlowArrays& arrays, const Limits& limits,
    vtkAlgorithm* owner, double start, double end);

  unsigned char GetKind(vtkIdType cell) const { return this->CellKinds[cell]; }
  /// Returns the number of cells with at least one of the bits in \a kinds.
  vtkIdType Count(unsigned char kinds) const;
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->CellKinds.size()); }

  /// Returns the unwrapped parameter of a corner of a cell that crosses a seam.
  static double Unwrap(double parameter) { return parameter < 0.5 ? parameter + 1.0 : parameter; }

private:
  std::vector<unsigned char> CellKinds;
  // Number of cells by kind.
  using KindCounts = std::array<vtkIdType, 256>;
  KindCounts Counts{};
};

}

#endif
