// SPDX-License-Identifier: BSD-3-Clause
#ifndef InflowPaint_h
#define InflowPaint_h

#include "vtkColor.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <functional>
#include <string>

class vtkDataSet;
class vtkImplicitFlowVolumeMapper;

/**
 * Images on termination surfaces, and volumes into which the flow carries these images.
 */
namespace gallery
{
/**
 * Color and opacity at a point of an image.
 */
struct Paint
{
  vtkColor3d Color;
  double Opacity = 0.0;
};
/**
 * Returns a float RGBA image of columns x rows points, from a function of u and v (0 to 1).
 */
vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Paint(double u, double v)>& paint);

/**
 * Draws a line of text into an image, centered horizontally. \a height is the font size and
 * \a center the vertical center, both as fractions of the image height.
 */
void DrawTextLine(vtkImageData* image, const std::string& text, const vtkColor3d& color,
  double opacity, double height, double center = 0.5);

/**
 * Returns a volume that shows \a image carried by the flow from the termination surfaces.
 */
vtkSmartPointer<vtkVolume> MakeInflowVolume(
  vtkDataSet* flow, vtkImageData* image, double unitDistance);
vtkImplicitFlowVolumeMapper* GetInflowMapper(vtkVolume* volume);

/**
 * Returns the image as an opaque texture for the termination surface, blended over the color
 * \a ground.
 */
vtkSmartPointer<vtkTexture> MakeInflowTexture(vtkImageData* image, const vtkColor3d& ground);
}

#endif
