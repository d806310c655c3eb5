// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FrameProjection_h
#define interlume_FrameProjection_h

#include "Common/Vectors.h"
#include "View/ViewRays.h"

namespace interlume
{

/**
 * @class   FrameProjection
 * @brief   projects the mesh's coordinates to those of a picture, and to its pixels
 *
 * Picture coordinates (x, y, d) are -1 to 1 from the left and the lower edge to the right and the
 * upper one, times the depth in perspective, and the depth d in units of the direction's length.
 * The line of sight of a pixel at (x, y) is (x, y, 1) d in perspective, (x, y, d) in parallel.
 */
class FrameProjection
{
public:
  explicit FrameProjection(const ViewRays& rays);

  /// Returns whether there are pixels, and the three axes do not lie in a plane.
  bool IsValid() const { return this->Valid; }
  bool IsParallel() const { return this->Parallel; }
  /// Returns whether what is counterclockwise in the mesh's coordinates is clockwise in the
  /// picture.
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
   * Return the centre of a column or row of pixels, moved by a hundred-millionth of a pixel to the
   * right and less up: edges and corners that line up with pixel centres, as those of a lattice do,
   * would otherwise be on either side by rounding.
   */
  double GetX(int i) const { return (2 * i + 1 + 2.0e-8) * this->PixelWidth - 1.0; }
  double GetY(int j) const { return (2 * j + 1 + 1.2e-8) * this->PixelHeight - 1.0; }
  ///@}

  /// The pixels first to last, whose centres may be in a range; none where first > last.
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
