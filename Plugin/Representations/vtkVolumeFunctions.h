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
 * @brief   chooses the colour and opacity functions that a representation draws with
 *
 * The functions are those that the representation was given, but for three cases, in which these
 * would show nothing or not what was asked for:
 * - without an array to colour by: the solid colour and the flat opacity;
 * - an opacity function between the ends of a range without width, which is what ParaView makes of
 *   the ramp when an array is constant: the flat opacity, since the ramp is 0 at that value;
 * - an Opacity below 1: all of the function times Opacity.
 */
class vtkVolumeFunctions
{
public:
  vtkVolumeFunctions();
  ~vtkVolumeFunctions();

  /// The opacity for the unit distance where there is no function to use, with which about ten
  /// cells hide the rest.
  static constexpr double FLAT_OPACITY = 0.1;

  ///@{
  /**
   * Set the functions to choose from; null stands for those of a new vtkVolumeProperty.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  ///@}

  /**
   * Sets the factor of all opacities for the unit distance. Default 1. Valid: 0 to 1, clamped.
   */
  void SetOpacity(double opacity);

  /**
   * Sets the colour without an array. Default white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Gives \a property the functions of an array, or those of a solid colour.
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
  /// The function and the factor that Scaled was made of.
  vtkPiecewiseFunction* ScaledSource = nullptr;
  vtkMTimeType ScaledTime = 0;
  double ScaledBy = 1.0;
};

#endif
