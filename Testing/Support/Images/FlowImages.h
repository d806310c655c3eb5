// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowImages_h
#define FlowImages_h

#include "Support/Images/RgbaImage.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class vtkCamera;
class vtkImageData;

/**
 * Implicit flow fields defined by formulas, images sampled from them, and reference renderings in
 * double precision that use neither samples nor textures.
 */
namespace reference
{

using Position3 = std::array<double, 3>;
using Color4 = std::array<double, 4>;

/// How the streamline through a point ends.
struct FlowEnd
{
  bool IsReached = true;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 0.0;
};

using FlowFormula = std::function<FlowEnd(const Position3&)>;
/// Returns red, green, blue, and the opacity per unit distance.
using PaintFormula = std::function<Color4(const FlowEnd&)>;

/// Returns an image with the arrays of vtkImplicitFlowField at n^3 points of the cube from -0.5 to
/// 0.5. \a surfaces are the tuples of the array TerminationSurfaces: id, and whether u and v are
/// periodic.
vtkSmartPointer<vtkImageData> MakeFlowVoxels(
  int n, const FlowFormula& flow, const std::vector<std::array<int, 3>>& surfaces = {});

/// Returns an RGBA float texture of \a columns x \a rows texels with the colors paint(u, v).
vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Color4(double u, double v)>& paint);

/// Returns the color of a texture at (u,v). Interpolation is bilinear, with RGB weighted by alpha.
Color4 LookUpPaint(vtkImageData* image, double u, double v);

/// A scene of one implicit flow field.
struct FlowScene
{
  FlowFormula Flow;
  PaintFormula Paint;
  std::array<int, 2> Size{ { 48, 48 } };
  vtkSmartPointer<vtkCamera> Camera;
  double UnitDistance = 0.1;
  /// Returns whether a point of the cube is drawn. If empty, all points are.
  std::function<bool(const Position3&)> IsRetained;
};

/// Renders a scene with \a pieces integration steps along each view ray inside the cube.
RgbaImage MakeFlowReferenceImage(const FlowScene& scene, int pieces = 4000);

}

#endif
