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
 * @brief   a spatial object defined by the point scalars of an image
 *
 * The first component of the active point scalars is interpolated trilinearly. With ScalarRange (a,
 * b), the density is (value - a) / (b - a), clamped to 0 ... 1, times Density. Outside the image
 * the density is 0. NaN scalars are treated as the value a. Update copies the values.
 *
 * Errors (vtkErrorMacro, density 0), in addition to those of vtkSpatialObject: there is no image,
 * it has no point scalars, or the color array is missing or has fewer than three components.
 */
class INTERLUMESOURCES_EXPORT vtkSpatialImage : public vtkSpatialLeaf
{
public:
  static vtkSpatialImage* New();
  vtkTypeMacro(vtkSpatialImage, vtkSpatialLeaf);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the image. Default null; evaluating without an image is an error.
   */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  ///@}

  ///@{
  /**
   * Set/Get the scalars a and b that map to densities 0 and 1. b may be less than a. Default 0, 1.
   * Valid: finite and different; other values are an error and are ignored.
   */
  void SetScalarRange(double a, double b);
  vtkGetVector2Macro(ScalarRange, double);
  ///@}

  ///@{
  /**
   * Set/Get the name of a point array with red, green and blue: 0 to 255 for unsigned char, 0 to 1
   * for other types. If the name is null or empty, all points have the color Color. Default: empty.
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
  /// Finds the corners of the cell at \a x and their weights. Returns false outside the image.
  bool Locate(const double x[3], vtkIdType corners[8], double weights[8]) const;

  int Extent[6];
  double PhysicalToIndex[16];
  /// Density of each point, not yet clamped to 0 ... 1, and color of each point.
  std::vector<float> Densities;
  std::vector<float> Colors;

  vtkSmartPointer<vtkImageData> Image;
  double ScalarRange[2] = { 0.0, 1.0 };
  std::string ColorArrayName;
};

#endif
