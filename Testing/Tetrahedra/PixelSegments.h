// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelSegments_h
#define PixelSegments_h

#include "Support/Images/CameraSettings.h" // for points

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
 * A segment of a pixel's view ray in world coordinates, given by two fractions of the distance from
 * the near to the far plane.
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

  /// Removes the part of the segment that lies behind a plane, on the side opposite to its normal.
  void Clip(const Point3& normal, const Point3& origin);
  /// Clips the segment to a box in the volume's coordinates.
  void ClipToBox(const std::array<double, 6>& box, vtkVolume* volume);

private:
  Point3 Near;
  Point3 Far;
  double From = 0.0;
  double To = 1.0;
};

/**
 * @class   PixelSegments
 * @brief   computes view rays with the inverse of the camera's world-to-clip matrix
 *
 * VTK's own mappers use this matrix, so it covers every kind of camera: stereo, sheared, off-axis,
 * and with user transforms.
 */
class PixelSegments
{
public:
  /// Reads the active camera. Call this after rendering, when the camera has the stereo settings
  /// and the eye of the frame.
  explicit PixelSegments(vtkRenderer* renderer);

  /// Returns the segment of pixel (i, j), counted from the renderer's lower left corner.
  PixelSegment Get(int i, int j) const;

private:
  Point3 Unproject(double x, double y, double z) const;

  vtkNew<vtkMatrix4x4> WorldFromClip;
  std::array<int, 2> Size;
};

/**
 * Checks hardware selection at every third pixel along each axis: the selected cell must contain
 * the point of the pixel's segment up to which its opacity is half of the total, and no cell may be
 * selected if \a cut makes the segment empty. \a extinction is a function of world coordinates.
 * Returns the number of checked pixels with cells. The volume must have been rendered before.
 */
int CheckSelection(Check& check, vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* grid,
  const std::function<void(PixelSegment&)>& cut,
  const std::function<double(const Point3&)>& extinction);

}

#endif
