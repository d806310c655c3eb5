// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkBoundedImageSource_h
#define vtkBoundedImageSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkImageAlgorithm.h"
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report

/**
 * @class   vtkBoundedImageSource
 * @brief   base class of image sources whose whole extent spans given bounds
 *
 * Subclasses can produce any part of the whole extent. The values do not depend on the requested
 * extent.
 *
 * @sa vtkAnalyticFieldSource vtkConstructiveVolume vtkTurbulenceSource
 */
class INTERLUMESOURCES_EXPORT vtkBoundedImageSource : public vtkImageAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBoundedImageSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the extent of the whole image, in point indices. Default 0 to 63 in each direction.
   * Valid: -32768 to 32767, with the upper index at least the lower index; clamped.
   */
  void SetWholeExtent(int x0, int x1, int y0, int y1, int z0, int z1);
  void SetWholeExtent(const int extent[6]);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  /**
   * Set the whole extent to start at 0, with the given number of points in each direction.
   */
  void SetDimensions(int x, int y, int z);

  ///@{
  /**
   * Set/Get the positions of the first and last points of the whole extent in each direction, in
   * units of length. In a direction with one point, the point is at the lower bound. Default -1 to
   * 1. Valid: finite, the lower bound less than the upper bound; other values are an error and are
   * ignored.
   */
  void SetBounds(double x0, double x1, double y0, double y1, double z0, double z1);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  /// Returns the report of the last execution: Points, Evaluations (number of positions where the
  /// field was evaluated), Bytes (size of the output) and Time. All are 0 after an error or abort.
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkBoundedImageSource();
  ~vtkBoundedImageSource() override = default;

  double GetLowerBound(int axis) const { return this->Bounds[2 * axis]; }
  double GetUpperBound(int axis) const { return this->Bounds[2 * axis + 1]; }

  /// Reports the geometry of the image, and that any sub-extent can be produced.
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Computes the position of index (0, 0, 0) and the spacing.
  void GetOriginAndSpacing(double origin[3], double spacing[3]) const;

  /// Sets the extent, origin and spacing of an image.
  void SetGeometry(vtkImageData* image, const int extent[6]) const;

private:
  vtkBoundedImageSource(const vtkBoundedImageSource&) = delete;
  void operator=(const vtkBoundedImageSource&) = delete;

  int WholeExtent[6] = { 0, 63, 0, 63, 0, 63 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  vtkNew<vtkInterlumeReport> Report;
};

#endif
