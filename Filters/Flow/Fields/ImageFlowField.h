// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageFlowField_h
#define interlume_ImageFlowField_h

#include "Fields/IndexedFlowField.h"

class vtkImageData;

namespace interlume
{

/**
 * @class   ImageFlowField
 * @brief   a field on an image, turned or not
 *
 * Errors of Build: those of the arrays; an image without cells of dimension 3; a spacing or
 * direction matrix that has no inverse.
 */
class ImageFlowField : public IndexedFlowField
{
public:
  /// Whether all cells have the same frame.
  static constexpr bool HasOneFrame = true;

  ImageFlowField() = default;

  Error Build(vtkImageData* image, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPart* part = nullptr);

  bool Locate(const double x[3], Place& place, double p[3]) const;
  /// Finds the cell that \a x is in, part of the field or not, and the place there.
  bool LocateIndex(const double x[3], int index[3], double p[3]) const;

  void GetPosition(const Place& place, const double p[3], double x[3]) const
  {
    const double q[3] = { place.Index[0] + p[0], place.Index[1] + p[1], place.Index[2] + p[2] };
    for (int i = 0; i < 3; ++i)
    {
      const double* row = this->Axes[i];
      x[i] = this->Origin[i] + (row[0] * q[0] + row[1] * q[1] + row[2] * q[2]);
    }
  }

  /// Computes dx[i]/dp[j], at [3 i + j].
  void GetFrame(const Place&, double frame[9]) const { Copy(this->Axes, frame); }
  void GetInverse(const Place&, double inverse[9]) const { Copy(this->Inverse, inverse); }

private:
  /// Computes the place in cells along each axis.
  void GetIndexPosition(const double x[3], double q[3]) const;

  static void Copy(const double from[3][3], double to[9])
  {
    for (int i = 0; i < 9; ++i)
    {
      to[i] = from[i / 3][i % 3];
    }
  }

  // The position of the first point; the frame; the numbers of cells along x, y, z.
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Axes[3][3] = {};
  double Inverse[3][3] = {};
  double Slack[3] = { 0.0, 0.0, 0.0 };
};

}

#endif
