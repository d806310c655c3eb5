// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowPictures_h
#define FlowPictures_h

#include "Support/Pictures/RgbaPicture.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class vtkCamera;
class vtkImageData;

/**
 * Implicit flow fields by formula, as voxels and as pictures in double precision that no voxel, no
 * texture and no float is in.
 */
namespace reference
{

using Place3 = std::array<double, 3>;
using Color4 = std::array<double, 4>;

/// Where a place's streamline ends.
struct FlowEnd
{
  bool IsReached = true;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 0.0;
};

using FlowFormula = std::function<FlowEnd(const Place3&)>;
/// Red, green, blue and opacity in a unit distance.
using PaintFormula = std::function<Color4(const FlowEnd&)>;

/// The arrays that vtkImplicitFlowField writes, at n^3 points of the cube from -0.5 to 0.5. The
/// ids are periodic as told, for u and v.
vtkSmartPointer<vtkImageData> MakeFlowVoxels(
  int n, const FlowFormula& flow, const std::vector<std::array<int, 3>>& surfaces = {});

/// An image of so many points along u and v, RGBA of floats, from a formula of (u,v).
vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Color4(double u, double v)>& paint);

/// The paint of an image between its points.
Color4 LookUpPaint(vtkImageData* image, double u, double v);

/// What is drawn.
struct FlowScene
{
  FlowFormula Flow;
  PaintFormula Paint;
  std::array<int, 2> Size{ { 48, 48 } };
  vtkSmartPointer<vtkCamera> Camera;
  double UnitDistance = 0.1;
  /// Places that are drawn, beside being in the cube; null for all.
  std::function<bool(const Place3&)> IsKept;
};

/// The picture of a scene, by so many pieces of each line of sight within the cube.
RgbaPicture MakeFlowPicture(const FlowScene& scene, int pieces = 4000);

}

#endif
