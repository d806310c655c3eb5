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
 * @brief   samples a spatial object of constructive volume geometry on an image
 *
 * The output has one point array, the active scalars:
 * - DENSITY: float, `Density`, 0 to 1;
 * - COLOR_BYTES: unsigned char with four components, `Color`: red, green, blue and the density, 0
 *   to 255, to draw with vtkVolumeProperty::IndependentComponentsOff;
 * - COLOR_FLOATS: float with four components, `Color`, 0 to 1.
 *
 * A point of density 0 has no colour of its own. It gets the mean of those of its 26 neighbours
 * that have density, else black, so that interpolation brings no foreign colour to an edge.
 *
 * The bytes do not depend on the number of threads. Any part of the whole extent is made alone,
 * with the same values as in the whole.
 *
 * Errors (vtkErrorMacro, empty output): no root; what is wrong with a part of it.
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

  /// Returns "density", "color bytes" or "color floats"; null for a number that is not a mode.
  static const char* GetOutputModeName(int mode);

  ///@{
  /**
   * The object that is sampled. Default null, which is an error when the output is made.
   */
  void SetRoot(vtkSpatialObject* root);
  vtkSpatialObject* GetRoot() const;
  ///@}

  ///@{
  /**
   * The array that is made. Default DENSITY. Valid: see OutputModes; clamped.
   */
  vtkSetClampMacro(OutputMode, int, DENSITY, COLOR_FLOATS);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToDensity() { this->SetOutputMode(DENSITY); }
  void SetOutputModeToColorBytes() { this->SetOutputMode(COLOR_BYTES); }
  void SetOutputModeToColorFloats() { this->SetOutputMode(COLOR_FLOATS); }
  ///@}

  ///@{
  /**
   * The number n of samples in each direction that make a value: the mean density over n^3 samples
   * of the cell around the point, and the mean colour weighted by density. Sharp edges become
   * smooth ones. Default 1, the sample at the point. Valid: 1 to 8; clamped.
   */
  vtkSetClampMacro(NumberOfSubsamples, int, 1, MaximumNumberOfSubsamples);
  vtkGetMacro(NumberOfSubsamples, int);
  static constexpr int MaximumNumberOfSubsamples = 8;
  ///@}

  /**
   * Sets the bounds to those of the root, each moved outward by \a margin of the longest side, and
   * the dimensions so that the longest side has \a resolution points and the spacings are as equal
   * as they can be. Gives an error, and changes nothing, without a root or when it is empty or has
   * no end.
   */
  void FitRoot(int resolution, double margin = 0.05);

  /**
   * Returns the density of the root at \a x, in the root's parent coordinates, which are those of
   * the image, and computes the colour where it is asked for.
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

  /// Computes the values of an extent. Returns false when the execution was aborted.
  bool Sample(const int extent[6], vtkDataArray* values);

  vtkSmartPointer<vtkSpatialObject> Root;
  int OutputMode = DENSITY;
  int NumberOfSubsamples = 1;
};

#endif
