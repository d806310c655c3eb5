// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstructiveVolume_h
#define vtkConstructiveVolume_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"
#include "vtkSmartPointer.h" // for the root

class vtkDataArray;
class vtkSpatialObject;

/**
 * @class   vtkConstructiveVolume
 * @brief   sample a spatial object of constructive volume geometry on an image
 *
 * The output has one point array, the active scalars:
 * - DENSITY: `Density`, float, 0 to 1;
 * - COLOR_BYTES: `Color`, unsigned char with four components, 0 to 255: red, green, blue and the
 *   density. Render it with vtkVolumeProperty::IndependentComponentsOff;
 * - COLOR_FLOATS: `Color`, float with four components, 0 to 1.
 *
 * A point of density 0 gets the mean color of those of its 26 neighbors that have nonzero density,
 * or black if there are none. Therefore interpolation at the edge of an object does not mix its
 * color with black.
 *
 * The output does not depend on the number of threads or on the requested extent.
 *
 * Errors (vtkErrorMacro, empty output): no Root is set, or a spatial object reports an error.
 *
 * @sa vtkSpatialObject vtkConstructiveModelSource
 */
class INTERLUMESOURCES_EXPORT vtkConstructiveVolume : public vtkBoundedImageSource
{
public:
  static vtkConstructiveVolume* New();
  vtkTypeMacro(vtkConstructiveVolume, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputModes
  {
    DENSITY = 0,
    COLOR_BYTES = 1,
    COLOR_FLOATS = 2,
    NUMBER_OF_OUTPUT_MODES = 3
  };

  /// Returns "density", "color bytes" or "color floats", or null if there is no such mode.
  static const char* GetOutputModeName(int mode);

  ///@{
  /**
   * Set/Get the object that is sampled. Default null; executing without a root is an error.
   */
  void SetRoot(vtkSpatialObject* root);
  vtkSpatialObject* GetRoot() const;
  ///@}

  ///@{
  /**
   * Set/Get the array of the output. Default DENSITY. Valid: see OutputModes; clamped.
   */
  vtkSetClampMacro(OutputMode, int, DENSITY, COLOR_FLOATS);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToDensity() { this->SetOutputMode(DENSITY); }
  void SetOutputModeToColorBytes() { this->SetOutputMode(COLOR_BYTES); }
  void SetOutputModeToColorFloats() { this->SetOutputMode(COLOR_FLOATS); }
  ///@}

  ///@{
  /**
   * Set/Get the number n of subsamples in each direction. A value is the mean density of n^3
   * samples in the cell around the point, and their mean color weighted by density. More subsamples
   * smooth sharp edges. Default 1, a single sample at the point. Valid: 1 to 8; clamped.
   */
  vtkSetClampMacro(NumberOfSubsamples, int, 1, MaximumNumberOfSubsamples);
  vtkGetMacro(NumberOfSubsamples, int);
  static constexpr int MaximumNumberOfSubsamples = 8;
  ///@}

  /**
   * Sets the bounds and dimensions from the root. The root's bounds are extended on each side by \a
   * margin times the longest side. The longest side gets \a resolution points, and the spacings are
   * as equal as possible. Reports an error and does nothing if there is no root or if its bounds
   * are empty or infinite.
   */
  void FitRoot(int resolution, double margin = 0.05);

  /**
   * Returns the density of the root at \a x, in the coordinates of the image. Computes the color if
   * \a color is not null.
   */
  double Evaluate(const double x[3], double color[3] = nullptr);

  vtkMTimeType GetMTime() override;

protected:
  vtkConstructiveVolume();
  ~vtkConstructiveVolume() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConstructiveVolume(const vtkConstructiveVolume&) = delete;
  void operator=(const vtkConstructiveVolume&) = delete;

  /// Computes the values of an extent. Returns false if the execution was aborted.
  bool Sample(const int extent[6], vtkDataArray* values);

  vtkSmartPointer<vtkSpatialObject> Root;
  int OutputMode = DENSITY;
  int NumberOfSubsamples = 1;
};

#endif
