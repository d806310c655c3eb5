// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkBoundedImageSource_h
#define vtkBoundedImageSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkImageAlgorithm.h"
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report

/**
 * @class   vtkBoundedImageSource
 * @brief   the lattice of sources of images: an extent of points, spread over bounds
 *
 * Each kind of source makes any part of the whole extent alone, with the same values as in the
 * whole.
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
   * The extent of the whole image, in point indices. Default 0 to 63 in each direction. Valid:
   * -32768 to 32767, the upper index not below the lower; clamped.
   */
  void SetWholeExtent(int x0, int x1, int y0, int y1, int z0, int z1);
  void SetWholeExtent(const int extent[6]);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  /**
   * Makes the whole extent start at 0 with so many points in each direction.
   */
  void SetDimensions(int x, int y, int z);

  ///@{
  /**
   * The positions of the first and the last points of the whole extent in each direction, in units
   * of length. Default -1 to 1. Valid: finite, the upper one above the lower; other values are an
   * error and change nothing. With one point in a direction the point is at the lower one.
   */
  void SetBounds(double x0, double x1, double y0, double y1, double z0, double z1);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  /// Returns the report of the last execution: Points, Evaluations (positions where the field was
  /// evaluated), Bytes (of the output) and Time. After an error or an abort all are 0.
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkBoundedImageSource();
  ~vtkBoundedImageSource() override = default;

  double GetLowerBound(int axis) const { return this->Bounds[2 * axis]; }
  double GetUpperBound(int axis) const { return this->Bounds[2 * axis + 1]; }

  /// Tells the pipeline where the image is, and that any part of it can be made.
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Computes the position of the point of index 0 and the distance of points.
  void GetLattice(double origin[3], double spacing[3]) const;

  /// Gives an image the extent, and the lattice's origin and spacing.
  void Place(vtkImageData* image, const int extent[6]) const;

private:
  vtkBoundedImageSource(const vtkBoundedImageSource&) = delete;
  void operator=(const vtkBoundedImageSource&) = delete;

  int WholeExtent[6] = { 0, 63, 0, 63, 0, 63 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  vtkNew<vtkInterlumeReport> Report;
};

#endif
