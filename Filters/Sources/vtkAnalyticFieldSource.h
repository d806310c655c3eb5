// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAnalyticFieldSource_h
#define vtkAnalyticFieldSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"

#include <functional> // for fields
#include <string>     // for the array's name

namespace interlume
{
struct FieldSampler;
}

/**
 * @class   vtkAnalyticFieldSource
 * @brief   scalar fields of space and time with known answers, on an image
 *
 * The fields f(x,t), x = (x,y,z) in units of length:
 *
 * - WAVE: f = z - 0.4 cos(pi (x + y/4 - t/2)). This is a travelling wave; the sheet -0.15 <= f <=
 * 0.15 moves a quarter of its wavelength in a unit of time. The region l <= f <= u has u - l of
 * every column within the bounds. It stands for the test function of C. Zhang, dissertation, Ohio
 * State 2006, figure 3.20: bounds -2 to 2, -1 to 1, -1 to 1, 40 x 20 x 20 points, times 0 and 1.
 * - VORTEX: the sum of eleven vortex tubes, each
 *     S(t) exp(-d^2 / r^2) exp(-(s/h)^4),  S(t) = exp(-((t-p)/q)^2),
 *   where s is the coordinate along the tube's straight line through c + v t and d the distance, to
 *   first order in curvature, from the axis
 *     B sin(k s + a + w t) e1 + (B/2) cos(1.6 (k s + a + w t)) e2
 *   around that line; e1, e2 are vtkMath::Perpendiculars of its direction at angle 0. It stands for
 * the vorticity magnitude of turbulence (ibid., figures 3.23 and 3.25), for bounds -1 to 1 and
 *   times 0 to 2; the constants are in the table of Vortices/VortexTubes.cxx. On 128^3 points the
 * interval 0.5 to 0.8 gives 78,000, 62,000 and 72,000 tetrahedra at times 0, 1 and 2. Six tubes
 * stay, three fade, two appear. In a unit of time they go four points, of five across a tube.
 * - LINEAR: f = Constant + Gradient . x + Rate t.
 * - BALL: f = |x - Center - Velocity t| - (Radius + Growth t). The region l <= f <= u is a
 *   spherical shell.
 * - GYROID: f = sin X cos Y + sin Y cos Z + sin Z cos X, (X,Y,Z) = 2 pi (x - Center - Velocity t):
 *   period 1 in each direction, half of the space has f <= 0.
 *
 * The output has one point array, the active scalars, and the time in DATA_TIME_STEP. The field is
 * evaluated at the requested time, whether it is one of the time steps, between them or outside
 * their range; without one, at the first time step.
 *
 * Errors (vtkErrorMacro, empty output): a time that is not finite.
 *
 * @sa vtkTaperedCylinderSource vtkDeltaWingSource
 */
class INTERLUMESOURCES_EXPORT vtkAnalyticFieldSource : public vtkBoundedImageSource
{
public:
  static vtkAnalyticFieldSource* New();
  vtkTypeMacro(vtkAnalyticFieldSource, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Fields
  {
    WAVE = 0,
    VORTEX = 1,
    LINEAR = 2,
    BALL = 3,
    GYROID = 4,
    NUMBER_OF_FIELDS = 5
  };

  /// Returns the field's name in small letters; null for a number that is not a field.
  static const char* GetFieldName(int field);

  ///@{
  /**
   * The field that is computed. Default VORTEX. Valid: see Fields; clamped.
   */
  vtkSetClampMacro(Field, int, WAVE, GYROID);
  vtkGetMacro(Field, int);
  void SetFieldToWave() { this->SetField(WAVE); }
  void SetFieldToVortex() { this->SetField(VORTEX); }
  void SetFieldToLinear() { this->SetField(LINEAR); }
  void SetFieldToBall() { this->SetField(BALL); }
  void SetFieldToGyroid() { this->SetField(GYROID); }
  ///@}

  ///@{
  /**
   * The coefficients of LINEAR: the value at the origin at time 0, the gradient per unit of length,
   * the rate per unit of time. Default 0, (1, 0, 0), 1. These and the values below are valid from
   * -1e6 to 1e6 and clamped; NaN changes nothing.
   */
  void SetConstant(double value) { this->SetNumber(this->Constant, value); }
  vtkGetMacro(Constant, double);
  void SetGradient(double x, double y, double z) { this->SetVector(this->Gradient, x, y, z); }
  vtkGetVector3Macro(Gradient, double);
  void SetRate(double value) { this->SetNumber(this->Rate, value); }
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /**
   * The positions of BALL and GYROID at time 0, and their velocity in units of length per unit of
   * time. Default (0, 0, 0), (0.1, 0, 0).
   */
  void SetCenter(double x, double y, double z) { this->SetVector(this->Center, x, y, z); }
  vtkGetVector3Macro(Center, double);
  void SetVelocity(double x, double y, double z) { this->SetVector(this->Velocity, x, y, z); }
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * The radius of BALL at time 0 in units of length, and its growth in a unit of time; a negative
   * radius is a field that is positive everywhere. Default 0.4, 0.1.
   */
  void SetRadius(double value) { this->SetNumber(this->Radius, value); }
  vtkGetMacro(Radius, double);
  void SetGrowth(double value) { this->SetNumber(this->Growth, value); }
  vtkGetMacro(Growth, double);
  ///@}

  /**
   * Returns the field at one point and time.
   */
  double Evaluate(const double x[3], double t) const { return this->GetFieldAtTime(t)(x); }

  ///@{
  /**
   * The number of time steps, evenly spaced over the time range. One step is at its start, and
   * there is one if the range has no length. Default 3. Valid: 1 to 100000; clamped.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 1, 100000);
  int GetNumberOfTimeSteps() const { return this->NumberOfTimeSteps; }
  ///@}

  ///@{
  /**
   * The times of the first and the last time step, in units of time. Default 0, 2. Valid: finite,
   * else an error; put in order.
   */
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->TimeRange; }
  ///@}

  ///@{
  /**
   * The type of the array: VTK_FLOAT or VTK_DOUBLE; any other type becomes VTK_FLOAT. Default
   * VTK_FLOAT.
   */
  void SetOutputScalarType(int type);
  int GetOutputScalarType() const { return this->OutputScalarType; }
  ///@}

  ///@{
  /**
   * The name of the point array. Default "f", which a null or empty name sets too.
   */
  void SetArrayName(const char* name);
  const char* GetArrayName() const { return this->ArrayName.c_str(); }
  ///@}

protected:
  vtkAnalyticFieldSource() = default;
  ~vtkAnalyticFieldSource() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnalyticFieldSource(const vtkAnalyticFieldSource&) = delete;
  void operator=(const vtkAnalyticFieldSource&) = delete;

  /// Returns the field at time \a t, for many positions. Several threads call the result.
  std::function<double(const double x[3])> GetFieldAtTime(double t) const;
  interlume::FieldSampler GetSampler() const;
  void SetNumber(double& member, double value);
  void SetVector(double (&member)[3], double x, double y, double z);

  int NumberOfTimeSteps = 3;
  double TimeRange[2] = { 0.0, 2.0 };
  int OutputScalarType = VTK_FLOAT;
  std::string ArrayName = "f";
  int Field = VORTEX;
  double Constant = 0.0;
  double Gradient[3] = { 1.0, 0.0, 0.0 };
  double Rate = 1.0;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Velocity[3] = { 0.1, 0.0, 0.0 };
  double Radius = 0.4;
  double Growth = 0.1;
};

#endif
