// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FrameProjection_h
#define interlume_FrameProjection_h

#include "Common/Vectors.h"
#include "View/ViewRays.h"

namespace interlume
{

/**
 * @class   FrameProjection
 * @brief   projects mesh coordinates to image coordinates and pixels
 *
 * Image coordinates are (x, y, d). d is the depth in units of the length of the view direction. x
 * and y are -1 at the left and lower edges of the image and 1 at the right and upper edges,
 * multiplied by d in perspective. The view ray of a pixel at (x, y) is (x, y, 1) d in perspective
 * and (x, y, d) in parallel projection.
 */
class FrameProjection
{
public:
  explicit FrameProjection(const ViewRays& rays);

  /// Returns true if the image has pixels and the three axes of the ViewRays are not coplanar.
  bool IsValid() const { return this->Valid; }
  bool IsParallel() const { return this->Parallel; }
  /// Returns true if triangles that are counterclockwise in mesh coordinates appear clockwise.
  bool IsMirrored() const { return this->Mirrored; }

  glm::dvec3 Project(const glm::dvec3& point) const
  {
    const glm::dvec3 p = point - this->Origin;
    return { glm::dot(this->Rows[0], p), glm::dot(this->Rows[1], p), glm::dot(this->Rows[2], p) };
  }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  ///@{
  /**
   * Return the center of a column or row of pixels, shifted by about 1e-8 pixels, by different
   * amounts in x and y. Otherwise pixel centers would often be exactly on edges or corners of a
   * regular grid, and rounding would decide on which side they are.
   */
  double GetX(int i) const { return (2 * i + 1 + 2.0e-8) * this->PixelWidth - 1.0; }
  double GetY(int j) const { return (2 * j + 1 + 1.2e-8) * this->PixelHeight - 1.0; }
  ///@}

  /// A range of columns or rows whose centers may be between two bounds; empty if First > Last.
  struct Range
  {
    int First;
    int Last;
  };
  Range GetColumns(double least, double greatest) const
  {
    return FindRange(least, greatest, this->Width);
  }
  Range GetRows(double least, double greatest) const
  {
    return FindRange(least, greatest, this->Height);
  }

private:
  static Range FindRange(double least, double greatest, int pixels);

  bool Valid = false;
  bool Parallel = false;
  bool Mirrored = false;
  glm::dvec3 Origin{};
  glm::dvec3 Rows[3]{};
  int Width = 0;
  int Height = 0;
  double PixelWidth = 0.0;
  double PixelHeight = 0.0;
};

}

#endif
