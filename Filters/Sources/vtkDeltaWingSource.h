// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkDeltaWingSource_h
#define vtkDeltaWingSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkTemporalGridSource.h"

/**
 * @class   vtkDeltaWingSource
 * @brief   the two vortices above a delta wing, and their breakdown, on a curvilinear grid
 *
 * This is a stand-in, with a formula, for the delta wing data of C. Zhang, dissertation, Ohio State
 * 2006, figure 3.22. The wing of length 1 lies in z = 0 with its apex at the origin; x leads along
 * it. Its half span is b(x) = x tan(90 degrees - SweepAngle).
 *
 * Grid: i along x from 0.1 to 1.2, j across, k up from the wing, conical. With i', j', k' = 0 to 1:
 *   x = 0.1 + 1.1 i',  y = 1.5 b (2 j' - 1),  z = 0.7 b k' (1 + k').
 * Cells are right-handed.
 *
 * Each side, e = 1 and e = -1, has a vortex that breaks down at
 *   X = BreakdownPosition + e BreakdownAmplitude sin(2 pi BreakdownFrequency t)
 * and winds in a spiral from there. With B = (1 + tanh((x - X) / 0.06)) / 2 and the angle
 * g = 2 pi ((x - X) / 0.34 - SpiralFrequency t) its axis passes
 *   e y = 0.62 b + 0.14 b B cos g,  z = 0.42 b + 0.14 b B sin g.
 * The array is, summed over both,
 *   loss = (1 - B/4) exp(-d^2 / s^2),  s = 0.12 b (1 + 0.4 B),
 * where d is the distance from the axis, to first order in its curvature: like the loss of total
 * pressure, 1 in the core and 0 outside.
 *
 * With the defaults the interval 0.4 to 0.7 gives about 180,000 tetrahedra: two tubes that swell
 * and wind downstream. In a unit of time the spiral turns by 54 degrees.
 *
 * Defaults: array "loss", 111 x 126 x 51 points.
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
   * The angle between the leading edge and the span, in degrees. Default 65. Valid: 30 to 85;
   * clamped.
   */
  void SetSweepAngle(double angle);
  vtkGetMacro(SweepAngle, double);
  ///@}

  ///@{
  /**
   * The mean x of the breakdown, in lengths of the wing. Default 0.55. Valid: 0 to 2; clamped.
   */
  void SetBreakdownPosition(double position);
  vtkGetMacro(BreakdownPosition, double);
  ///@}

  ///@{
  /**
   * The amplitude by which the breakdown moves to and fro, in lengths of the wing, in opposite
   * sense on the two sides, and its frequency in a unit of time. Default 0.06, 0.2. Valid: 0 to 1,
   * 0 to 1000; clamped.
   */
  void SetBreakdownAmplitude(double amplitude);
  vtkGetMacro(BreakdownAmplitude, double);
  void SetBreakdownFrequency(double frequency);
  vtkGetMacro(BreakdownFrequency, double);
  ///@}

  ///@{
  /**
   * The number of turns of the spiral in a unit of time. Default 0.15. Valid: 0 to 1000; clamped.
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

  /// Returns half of the span at x = 1.
  double GetHalfSpan() const;

  double SweepAngle = 65.0;
  double BreakdownPosition = 0.55;
  double BreakdownAmplitude = 0.06;
  double BreakdownFrequency = 0.2;
  double SpiralFrequency = 0.15;
};

#endif
