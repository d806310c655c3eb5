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
 * Images that are painted on termination surfaces, and the volumes they make.
 */
namespace gallery
{
/**
 * Columns times rows of RGBA, transparent, or by a function of u and v from 0 to 1 that gives
 * colour and opacity.
 */
struct Paint
{
  vtkColor3d Colour;
  double Opacity = 0.0;
};
vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Paint(double u, double v)>& paint);

/**
 * Writes a line of text into the middle of an image, \a height as a share of its rows.
 */
void WriteText(vtkImageData* image, const std::string& text, const vtkColor3d& colour,
  double opacity, double height, double middle = 0.5);

/**
 * An implicit flow field that \a image is carried through.
 */
vtkSmartPointer<vtkVolume> MakeInflowVolume(
  vtkDataSet* flow, vtkImageData* image, double unitDistance);
vtkImplicitFlowVolumeMapper* GetInflowMapper(vtkVolume* volume);

/**
 * The image as an opaque texture over a plain \a ground, for the termination surface.
 */
vtkSmartPointer<vtkTexture> MakeInflowTexture(vtkImageData* image, const vtkColor3d& ground);
}

#endif
