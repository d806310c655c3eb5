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
 * Lights that shine through a screen, and what is on their screens.
 */
namespace gallery
{
class Panel;
class Stage;

/**
 * An image of width x height samples: \a pattern of u and v, 0 to 1 from the lower left, each
 * sample the mean over its area. RGB, unsigned char.
 */
vtkSmartPointer<vtkImageData> MakePattern(
  int width, int height, const std::function<vtkColor3d(double, double)>& pattern);

/// White with \a lines dark lines across each direction, which take \a share of it.
vtkSmartPointer<vtkImageData> MakeGridPattern(int lines, double share);

/// White within a disk that fills the image, black outside, with a soft edge that takes \a edge of
/// the radius.
vtkSmartPointer<vtkImageData> MakeSoftDisk(double edge);

/**
 * A light at \a position that shines through a screen of width x height around \a centre, \a
 * image on it, or nothing.
 */
vtkSmartPointer<vtkProjectiveLight> MakeProjector(const vtkVector3d& position,
  const vtkVector3d& centre, double width, double height, double intensity,
  vtkImageData* image = nullptr);

/// The same with parallel rays.
vtkSmartPointer<vtkProjectiveLight> MakeParallelProjector(const vtkVector3d& position,
  const vtkVector3d& centre, double width, double height, double intensity,
  vtkImageData* image = nullptr);

/// A light from far away out of direction \a from that casts no shadows, so that what lies in
/// shadow has form.
vtkSmartPointer<vtkLight> MakeFillLight(const vtkVector3d& from, double intensity);

/// Parallel rays of a round beam, whose edge is soft.
vtkSmartPointer<vtkProjectiveLight> MakeBeam(const vtkVector3d& position, const vtkVector3d& centre,
  double diameter, double intensity, const vtkColor3d& colour);

/**
 * Adds a panel of \a image, solid matter, in a light with a pattern and a weak one from the right.
 */
Panel& AddPatternPanel(Stage& stage, vtkImageData* image, vtkProjectiveLight* light);
}

#endif
