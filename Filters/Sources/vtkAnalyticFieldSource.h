// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAnalyticFieldSource_h
#define vtkAnalyticFieldSource_h

#include "vtkDeprecation.h"         // for VTK_DEPRECATION
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
 * @brief   generate analytic scalar fields of space and time on an image
 *
 * Let x = (x,y,z) be the position and t the time. The fields f(x,t) are
 * - WAVE: the traveling wave f = z - 0.4 cos(pi (x + y/4 - t/2)).
 * - VORTEX: eleven vortex tubes that drift, bend, grow and fade.
 * - LINEAR: f = Constant + Gradient . x + Rate t.
 * - SPHERE_DISTANCE: f = |x - Center - Velocity t| - (Radius + Growth t). The region l <= f <= u is
 *   a spherical shell.
 * - GYROID: f = sin X cos Y + sin Y cos Z + sin Z cos X, (X,Y,Z) = 2 pi (x - Center - Velocity t).
 *   It has period 1 in each direction, and f <= 0 in half of each unit cell.
 *
 * WAVE and VORTEX replace two data sets of C. Zhang's dissertation, Ohio State 2006, figures 3.20
 * and 3.23; see Documentation/methods/sources.md for their formulas and suitable bounds.
 *
 * The output has one point array, the active scalars, and the time in DATA_TIME_STEP. The field is
 * evaluated at the requested time, which need not be a time step or lie within the time range.
 * Without a request, the first time step is used.
 *
 * Errors (vtkErrorMacro, empty output): the requested time is not finite.
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
    SPHERE_DISTANCE = 3,
    BALL = SPHERE_DISTANCE, ///< deprecated name
    GYROID = 4,
    NUMBER_OF_FIELDS = 5
  };

  /// Returns the lowercase name of a field, or null if there is no such field.
  static const char* GetFieldName(int field);

  ///@{
  /**
   * Set/Get the field. Default VORTEX. Valid: see Fields; clamped.
   */
  vtkSetClampMacro(Field, int, WAVE, GYROID);
  vtkGetMacro(Field, int);
  void SetFieldToWave() { this->SetField(WAVE); }
  void SetFieldToVortex() { this->SetField(VORTEX); }
  void SetFieldToLinear() { this->SetField(LINEAR); }
  void SetFieldToSphereDistance() { this->SetField(SPHERE_DISTANCE); }
  VTK_DEPRECATION("Use SetFieldToSphereDistance.")
  void SetFieldToBall() { this->SetFieldToSphereDistance(); }
  void SetFieldToGyroid() { this->SetField(GYROID); }
  ///@}

  ///@{
  /**
   * Set/Get the coefficients of LINEAR: the value at the origin at time 0, the gradient per unit of
   * length, and the rate per unit of time. Default 0, (1, 0, 0), 1. These parameters, as well as
   * Center, Velocity, Radius and Growth, are clamped to -1e6 ... 1e6; NaN is ignored.
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
   * Set/Get the position of SPHERE_DISTANCE and GYROID at time 0, and its velocity in units of
   * length per unit of time. Default (0, 0, 0), (0.1, 0, 0).
   */
  void SetCenter(double x, double y, double z) { this->SetVector(this->Center, x, y, z); }
  vtkGetVector3Macro(Center, double);
  void SetVelocity(double x, double y, double z) { this->SetVector(this->Velocity, x, y, z); }
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of SPHERE_DISTANCE at time 0 in units of length, and its growth per unit of
   * time. While the radius is negative, the field is positive everywhere. Default 0.4, 0.1.
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
   * Set/Get the number of time steps, evenly spaced over the time range. A single step is at the
   * start of the range. A range of zero length has a single step. Default 3. Valid: 1 to 100000;
   * clamped.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 1, 100000);
  int GetNumberOfTimeSteps() const { return this->NumberOfTimeSteps; }
  ///@}

  ///@{
  /**
   * Set/Get the times of the first and last time step, in units of time. The two values are sorted.
   * Default 0, 2. Valid: finite; other values are an error and are ignored.
   */
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->TimeRange; }
  ///@}

  ///@{
  /**
   * Set/Get the type of the array: VTK_FLOAT or VTK_DOUBLE. Other types become VTK_FLOAT. Default
   * VTK_FLOAT.
   */
  void SetOutputScalarType(int type);
  int GetOutputScalarType() const { return this->OutputScalarType; }
  ///@}

  ///@{
  /**
   * Set/Get the name of the point array. A null or empty name restores the default, "f".
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

  /// Returns the field at time \a t. Several threads may call the result concurrently.
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
