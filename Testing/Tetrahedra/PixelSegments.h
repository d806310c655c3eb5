// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelSegments_h
#define PixelSegments_h

#include "Support/Pictures/PictureSettings.h" // for points

#include "vtkNew.h"

#include <array>      // for planes and boxes
#include <functional> // for cuts

class vtkDataSet;
class vtkMatrix4x4;
class vtkRenderer;
class vtkVolume;

namespace reference
{

class Check;

/**
 * The part of a pixel's view ray between two fractions of the way from the near to the far plane,
 * in the world.
 */
class PixelSegment
{
public:
  PixelSegment(const Point3& near, const Point3& far)
    : Near(near)
    , Far(far)
  {
  }

  bool IsEmpty() const { return !(this->From < this->To); }
  double GetLength() const;
  Point3 GetFront() const { return this->At(this->From); }
  Point3 GetBack() const { return this->At(this->To); }
  double GetFrom() const { return this->From; }
  double GetTo() const { return this->To; }
  Point3 At(double fraction) const;

  /// Cuts off the side of a plane that its normal does not point to.
  void Clip(const Point3& normal, const Point3& origin);
  /// Keeps the part within a box of a volume's coordinates.
  void ClipToBox(const std::array<double, 6>& box, vtkVolume* volume);

private:
  Point3 Near;
  Point3 Far;
  double From = 0.0;
  double To = 1.0;
};

/**
 * @class   PixelSegments
 * @brief   view rays by the inverse of the camera's matrix from world to clip coordinates
 *
 * The inverse of the matrix that VTK's own mappers project with serves every kind of camera:
 * stereo, sheared, off-axis, and with the camera's user transforms.
 */
class PixelSegments
{
public:
  /// The camera is read as it is after a frame, with the eye and the stereo flag of that.
  explicit PixelSegments(vtkRenderer* renderer);

  /// Returns the segment of a pixel that is counted from the renderer's lower left corner.
  PixelSegment Get(int i, int j) const;

private:
  Point3 Unproject(double x, double y, double z) const;

  vtkNew<vtkMatrix4x4> WorldFromClip;
  std::array<int, 2> Size;
};

/**
 * Checks that a selector finds at every third pixel a cell of the volume's grid that the pixel's
 * segment enters first, and none where \a cut leaves nothing of the segment. Returns the number of
 * pixels with cells. The renderer has drawn the volume.
 */
int CheckSelection(Check& check, vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* grid,
  const std::function<void(PixelSegment&)>& cut);

}

#endif
