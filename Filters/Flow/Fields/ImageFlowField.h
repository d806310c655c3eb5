// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageFlowField_h
#define interlume_ImageFlowField_h

#include "Fields/IndexedFlowField.h"

class vtkImageData;

namespace interlume
{

/**
 * @class   ImageFlowField
 * @brief   field on an image, with any direction matrix
 *
 * Build() returns an error if an array is invalid, if the image has no three-dimensional cells, or
 * if the direction matrix times the spacing is singular.
 */
class ImageFlowField : public IndexedFlowField
{
public:
  /// True if dx/dp is the same in all cells.
  static constexpr bool HasOneFrame = true;

  ImageFlowField() = default;

  Error Build(vtkImageData* image, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPartition* part = nullptr);

  bool Locate(const double x[3], CellLocation& location, double p[3]) const;
  /// Finds the cell that contains \a x, even if it is excluded, and the local position.
  bool LocateIndex(const double x[3], int index[3], double p[3]) const;

  void GetPosition(const CellLocation& location, const double p[3], double x[3]) const
  {
    const double q[3] = { location.Index[0] + p[0], location.Index[1] + p[1],
      location.Index[2] + p[2] };
    for (int i = 0; i < 3; ++i)
    {
      const double* row = this->Axes[i];
      x[i] = this->Origin[i] + (row[0] * q[0] + row[1] * q[1] + row[2] * q[2]);
    }
  }

  /// Computes frame[3 * i + j] = dx[i]/dp[j].
  void GetFrame(const CellLocation&, double frame[9]) const { Copy(this->Axes, frame); }
  void GetInverse(const CellLocation&, double inverse[9]) const { Copy(this->Inverse, inverse); }

private:
  /// Converts \a x to a position \a q in units of cells along each axis.
  void GetContinuousIndex(const double x[3], double q[3]) const;

  static void Copy(const double from[3][3], double to[9])
  {
    for (int i = 0; i < 9; ++i)
    {
      to[i] = from[i / 3][i % 3];
    }
  }

  // Position of the first point, dx/dp and its inverse, and the tolerance at the boundary in units
  // of cells.
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Axes[3][3] = {};
  double Inverse[3][3] = {};
  double Slack[3] = { 0.0, 0.0, 0.0 };
};

}

#endif
