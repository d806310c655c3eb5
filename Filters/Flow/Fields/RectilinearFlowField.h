// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RectilinearFlowField_h
#define interlume_RectilinearFlowField_h

#include "Fields/IndexedFlowField.h"

class vtkRectilinearGrid;

namespace interlume
{

/**
 * @class   RectilinearFlowField
 * @brief   a field on a rectilinear grid
 *
 * Errors of Build: those of the arrays; a grid without cells of dimension 3; coordinates that turn
 * back, repeat or are not finite.
 */
class RectilinearFlowField : public IndexedFlowField
{
public:
  static constexpr bool HasOneFrame = false;

  RectilinearFlowField() = default;

  Error Build(vtkRectilinearGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPart* part = nullptr);

  bool Locate(const double x[3], Place& place, double p[3]) const;
  /// Finds the cell that \a x is in, part of the field or not, and the place there.
  bool LocateIndex(const double x[3], int index[3], double p[3]) const;

  void GetPosition(const Place& place, const double p[3], double x[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Both ends of an edge come out exactly, so that neighbours agree.
      const double* ends = this->GetEnds(place, axis);
      x[axis] = (1.0 - p[axis]) * ends[0] + p[axis] * ends[1];
    }
  }

  /// Computes dx[i]/dp[j], at [3 i + j].
  void GetFrame(const Place& place, double frame[9]) const
  {
    for (int i = 0; i < 9; ++i)
    {
      frame[i] = i % 4 ? 0.0 : this->GetWidth(place, i / 4);
    }
  }
  void GetInverse(const Place& place, double inverse[9]) const
  {
    for (int i = 0; i < 9; ++i)
    {
      inverse[i] = i % 4 ? 0.0 : 1.0 / this->GetWidth(place, i / 4);
    }
  }

private:
  /// Computes the place in cells along each axis, and what counts as on the grid's faces.
  void GetIndexPosition(const double x[3], double q[3], double slack[3]) const;

  const double* GetEnds(const Place& place, int axis) const
  {
    return this->Coordinates[axis].data() + place.Index[axis];
  }
  double GetWidth(const Place& place, int axis) const
  {
    const double* ends = this->GetEnds(place, axis);
    return ends[1] - ends[0];
  }

  std::vector<double> Coordinates[3];
  // The largest coordinates, which x is rounded relative to.
  double Magnitude[3] = { 0.0, 0.0, 0.0 };
};

}

#endif
