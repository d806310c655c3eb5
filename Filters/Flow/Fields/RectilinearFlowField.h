// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RectilinearFlowField_h
#define interlume_RectilinearFlowField_h

#include "Fields/IndexedFlowField.h"

class vtkRectilinearGrid;

namespace interlume
{

/**
 * @class   RectilinearFlowField
 * @brief   field on a rectilinear grid
 *
 * Build() returns an error if an array is invalid, if the grid has no three-dimensional cells, or
 * if coordinates are not strictly monotonic or not finite.
 */
class RectilinearFlowField : public IndexedFlowField
{
public:
  static constexpr bool HasOneFrame = false;

  RectilinearFlowField() = default;

  Error Build(vtkRectilinearGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPartition* part = nullptr);

  bool Locate(const double x[3], CellLocation& location, double p[3]) const;
  /// Finds the cell that contains \a x, even if it is excluded, and the local coordinates of \a x.
  bool LocateIndex(const double x[3], int index[3], double p[3]) const;

  void GetPosition(const CellLocation& location, const double p[3], double x[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // This formula is exact at both ends, so neighbors agree on the position of their common
      // face.
      const double* ends = this->GetEnds(location, axis);
      x[axis] = (1.0 - p[axis]) * ends[0] + p[axis] * ends[1];
    }
  }

  /// Computes frame[3 * i + j] = dx[i]/dp[j].
  void GetFrame(const CellLocation& location, double frame[9]) const
  {
    for (int i = 0; i < 9; ++i)
    {
      frame[i] = i % 4 ? 0.0 : this->GetWidth(location, i / 4);
    }
  }
  void GetInverse(const CellLocation& location, double inverse[9]) const
  {
    for (int i = 0; i < 9; ++i)
    {
      inverse[i] = i % 4 ? 0.0 : 1.0 / this->GetWidth(location, i / 4);
    }
  }

private:
  /// Computes the continuous cell indices \a q of \a x, and the tolerance at the boundary of the
  /// grid in the same units.
  void GetContinuousIndex(const double x[3], double q[3], double slack[3]) const;

  const double* GetEnds(const CellLocation& location, int axis) const
  {
    return this->Coordinates[axis].data() + location.Index[axis];
  }
  double GetWidth(const CellLocation& location, int axis) const
  {
    const double* ends = this->GetEnds(location, axis);
    return ends[1] - ends[0];
  }

  std::vector<double> Coordinates[3];
  // Largest absolute coordinate along each axis, which determines the rounding error.
  double Magnitude[3] = { 0.0, 0.0, 0.0 };
};

}

#endif
