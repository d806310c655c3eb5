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
 * @brief   which cells of an implicit flow field can be interpolated in, and which lie across a
 * seam
 *
 * A cell whose parameters differ by more than half a period has its corners on both sides of the
 * seam. They are unwrapped by adding a period to those below one half.
 * ImplicitFlowArrays::IsAcrossSurface tells what lies across a surface.
 */
class InterpolableCells
{
public:
  /// The kinds of a cell, as bits.
  enum Kinds : unsigned char
  {
    ACROSS_U = 1,
    ACROSS_V = 2,
    ACROSS = ACROSS_U | ACROSS_V,
    /// The cell is left out, for one of these reasons.
    WITHOUT_ANSWER = 4,
    BETWEEN_SURFACES = 8,
    ON_SEAM = 16,
    ACROSS_SURFACE = 64,
    TIME_JUMP = 128,
    LEFT_OUT = WITHOUT_ANSWER | BETWEEN_SURFACES | ON_SEAM | ACROSS_SURFACE | TIME_JUMP,
    /// The cell lies across a seam, and no unwrapping brings the corners within half a period.
    AROUND_POLE = 32
  };

  /// Whether u and v go on over their seams, by id.
  using Continuity = std::map<int, std::array<bool, 2>>;

  /// The limits of what can be interpolated over.
  struct Limits
  {
    Continuity Seams;
    /// The largest difference between the times of a cell's corners; 0 stands for no limit.
    double MaximumTimeJump = 0.0;
  };

  /// Finds the kind of each cell of \a data. Returns false when \a owner was aborted.
  bool Find(vtkDataSet* data, const ImplicitFlowArrays& arrays, const Limits& limits,
    vtkAlgorithm* owner, double start, double end);

  unsigned char GetKind(vtkIdType cell) const { return this->CellKinds[cell]; }
  /// Returns how many cells are of any of \a kinds.
  vtkIdType Count(unsigned char kinds) const;
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->CellKinds.size()); }

  /// Returns the unwrapped parameter of a corner of a cell across a seam.
  static double Unwrap(double parameter) { return parameter < 0.5 ? parameter + 1.0 : parameter; }

private:
  std::vector<unsigned char> CellKinds;
  // The numbers of cells by kind.
  using KindCounts = std::array<vtkIdType, 256>;
  KindCounts Counts{};
};

}

#endif
