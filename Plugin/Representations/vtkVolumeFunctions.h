// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkVolumeFunctions_h
#define vtkVolumeFunctions_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

/**
 * @class   vtkVolumeFunctions
 * @brief   chooses the color and opacity functions of a volume property
 *
 * The functions that were set are used, with three exceptions:
 * - If there is no color array, the solid color and a constant opacity are used.
 * - If the array is constant, ParaView rescales the opacity ramp to a very narrow range, and the
 *   opacity of the array's only value is 0. A constant opacity is used instead, so that the volume
 *   is visible.
 * - If Opacity is below 1, the opacity function is multiplied by it.
 */
class vtkVolumeFunctions
{
public:
  vtkVolumeFunctions();
  ~vtkVolumeFunctions();

  /// Constant opacity per unit distance. At this opacity, about ten cells hide most of the
  /// background.
  static constexpr double FLAT_OPACITY = 0.1;

  ///@{
  /**
   * Set the functions of the color array. Null selects the default functions of vtkVolumeProperty.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  ///@}

  /**
   * Sets the factor that multiplies all opacities per unit distance. Default: 1. Valid: 0 to 1;
   * clamped.
   */
  void SetOpacity(double opacity);

  /**
   * Sets the color to use if there is no color array. Default: white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Sets the functions of \a property: those of the color array if \a hasArray is true, otherwise
   * those for the solid color.
   */
  void Apply(vtkVolumeProperty* property, bool hasArray);

private:
  vtkPiecewiseFunction* GetShownOpacity();

  vtkSmartPointer<vtkColorTransferFunction> Color;
  vtkSmartPointer<vtkPiecewiseFunction> ScalarOpacity;
  double Opacity = 1.0;
  double SolidColor[3] = { 1.0, 1.0, 1.0 };
  vtkNew<vtkColorTransferFunction> Solid;
  vtkNew<vtkPiecewiseFunction> Flat;
  vtkNew<vtkPiecewiseFunction> Scaled;
  /// Inputs from which Scaled was computed: the function, its modification time, and the factor.
  vtkPiecewiseFunction* ScaledSource = nullptr;
  vtkMTimeType ScaledTime = 0;
  double ScaledBy = 1.0;
};

#endif
