// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkDeltaWingSource_h
#define vtkDeltaWingSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkTemporalGridSource.h"

/**
 * @class   vtkDeltaWingSource
 * @brief   generate two vortices that break down above a delta wing, on a curvilinear grid
 *
 * An analytic replacement for the delta wing data of C. Zhang, dissertation, Ohio State 2006,
 * figure 3.22. The wing has length 1 and lies in z = 0, with its apex at the origin and x along its
 * axis. The grid is conical: i runs along x from 0.1 to 1.2, j across the wing and k upward. Cells
 * are right-handed.
 *
 * On each side, a vortex breaks down into a spiral. The array resembles the loss of total
 * pressure: 1 in the core of a vortex and 0 outside. See Documentation/methods/sources.md for the
 * formulas.
 *
 * Defaults: array "loss", 111 x 126 x 51 points. The interval 0.4 to 0.7 consists of two tubes that
 * widen and wind downstream.
 *
 * @sa vtkTemporalGridSource
 */
class INTERLUMESOURCES_EXPORT vtkDeltaWingSource : public vtkTemporalGridSource
{
public:
  static vtkDeltaWingSource* New();
  vtkTypeMacro(vtkDeltaWingSource, vtkTemporalGridSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void GetPosition(const int ijk[3], double x[3]) const override;

  ///@{
  /**
   * Set/Get the angle between the leading edge and the span, in degrees. Default 65. Valid: 30 to
   * 85; clamped.
   */
  void SetSweepAngle(double angle);
  vtkGetMacro(SweepAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the mean x coordinate of the breakdown, in wing lengths. Default 0.55. Valid: 0 to 2;
   * clamped.
   */
  void SetBreakdownPosition(double position);
  vtkGetMacro(BreakdownPosition, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitude of the breakdown's oscillation, in wing lengths, and its frequency per
   * unit of time. The breakdowns on the two sides move in opposite directions. Default 0.06, 0.2.
   * Valid: 0 to 1, 0 to 1000; clamped.
   */
  void SetBreakdownAmplitude(double amplitude);
  vtkGetMacro(BreakdownAmplitude, double);
  void SetBreakdownFrequency(double frequency);
  vtkGetMacro(BreakdownFrequency, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of turns of the spiral per unit of time. Default 0.15. Valid: 0 to 1000;
   * clamped.
   */
  void SetSpiralFrequency(double frequency);
  vtkGetMacro(SpiralFrequency, double);
  ///@}

protected:
  vtkDeltaWingSource();
  ~vtkDeltaWingSource() override = default;

  Field GetFieldAtTime(double t) const override;

private:
  vtkDeltaWingSource(const vtkDeltaWingSource&) = delete;
  void operator=(const vtkDeltaWingSource&) = delete;

  /// Returns the half span at x = 1.
  double GetHalfSpan() const;

  double SweepAngle = 65.0;
  double BreakdownPosition = 0.55;
  double BreakdownAmplitude = 0.06;
  double BreakdownFrequency = 0.2;
  double SpiralFrequency = 0.15;
};

#endif
