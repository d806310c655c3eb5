// SPDX-License-Identifier: BSD-3-Clause
#ifndef LightScreens_h
#define LightScreens_h

#include "vtkColor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkProjectiveLight.h"
#include "vtkSmartPointer.h"
#include "vtkVector.h"

#include <functional>

/**
 * Lights that shine through screens, and the images on these screens.
 */
namespace gallery
{
class Panel;
class Stage;

/**
 * Returns an RGB image (unsigned char) of width x height samples. \a pattern is a function of u and
 * v, which range from 0 to 1, with the origin at the lower left corner. Each sample is the mean of
 * the pattern over the area of the sample.
 */
vtkSmartPointer<vtkImageData> MakePattern(
  int width, int height, const std::function<vtkColor3d(double, double)>& pattern);

/// Returns a white image with \a lines dark lines along each axis. \a fraction is the fraction of
/// the spacing that a line covers.
vtkSmartPointer<vtkImageData> MakeGridPattern(int lines, double fraction);

/// Returns an image of a white disk on black. The disk touches the edges of the image. The width of
/// its soft edge is \a edge times the radius.
vtkSmartPointer<vtkImageData> MakeSoftDiskImage(double edge);

/**
 * Returns a point light at \a position that shines through a screen of width x height around
 * \a center. \a image is the image on the screen, if any.
 */
vtkSmartPointer<vtkProjectiveLight> MakeProjector(const vtkVector3d& position,
  const vtkVector3d& center, double width, double height, double intensity,
  vtkImageData* image = nullptr);

/// As above, but the light rays are parallel.
vtkSmartPointer<vtkProjectiveLight> MakeParallelProjector(const vtkVector3d& position,
  const vtkVector3d& center, double width, double height, double intensity,
  vtkImageData* image = nullptr);

/// Returns a directional light that shines from direction \a from without casting shadows, so that
/// shapes in shadow remain visible.
vtkSmartPointer<vtkLight> MakeFillLight(const vtkVector3d& from, double intensity);

/// Returns a parallel light whose beam is round and has a soft edge.
vtkSmartPointer<vtkProjectiveLight> MakeBeam(const vtkVector3d& position, const vtkVector3d& center,
  double diameter, double intensity, const vtkColor3d& color);

/**
 * Adds a panel of \a image as a solid medium, lit by \a light and by a weak light from the right.
 */
Panel& AddPatternPanel(Stage& stage, vtkImageData* image, vtkProjectiveLight* light);
}

#endif
