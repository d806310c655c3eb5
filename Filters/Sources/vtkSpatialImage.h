// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialImage_h
#define vtkSpatialImage_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialLeaf.h"

#include <vector> // for the values

class vtkImageData;

namespace interlume
{
class Error;
}

/**
 * @class   vtkSpatialImage
 * @brief   an image's point scalars as a spatial object
 *
 * The first component of the active point scalars, interpolated trilinearly, gives the density
 * (value - a) / (b - a), clamped to 0 ... 1, times Density, with ScalarRange (a, b). Outside the
 * image the density is 0. A scalar that is NaN counts as a. The values are copied when the object
 * is made ready.
 *
 * Errors (vtkErrorMacro, density 0) besides those of vtkSpatialObject: no image, or one without
 * point scalars; a colour array that is not there or has fewer than three components.
 */
class INTERLUMESOURCES_EXPORT vtkSpatialImage : public vtkSpatialLeaf
{
public:
  static vtkSpatialImage* New();
  vtkTypeMacro(vtkSpatialImage, vtkSpatialLeaf);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The image. Default null, which is an error when the object is evaluated.
   */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  ///@}

  ///@{
  /**
   * The scalars a and b with density 0 and 1; b may be below a. Default 0, 1. Valid: finite and
   * different; other values are an error and change nothing.
   */
  void SetScalarRange(double a, double b);
  vtkGetVector2Macro(ScalarRange, double);
  ///@}

  ///@{
  /**
   * The name of a point array with red, green, blue: 0 to 255 for unsigned char, else 0 to 1.
   * Empty, the default, or null: Color everywhere.
   */
  void SetColorArrayName(const char* name);
  const char* GetColorArrayName() const { return this->ColorArrayName.c_str(); }
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialImage();
  ~vtkSpatialImage() override;

  std::string Prepare(double bounds[6]) override;
  bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const override;

private:
  vtkSpatialImage(const vtkSpatialImage&) = delete;
  void operator=(const vtkSpatialImage&) = delete;

  interlume::Error CopyValues();
  interlume::Error CopyColors();
  /// Finds the cell's corners with their weights. Returns false outside the image.
  bool Locate(const double x[3], vtkIdType corners[8], double weights[8]) const;

  int Extent[6];
  double PhysicalToIndex[16];
  /// The densities before they are clamped, and the colours, for each point.
  std::vector<float> Densities;
  std::vector<float> Colors;

  vtkSmartPointer<vtkImageData> Image;
  double ScalarRange[2] = { 0.0, 1.0 };
  std::string ColorArrayName;
};

#endif
