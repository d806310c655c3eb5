// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalImageSource_h
#define vtkTemporalImageSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkBoundedImageSource.h"
#include "vtkFieldSampler.h" // for the time steps and the array

/**
 * @class   vtkTemporalImageSource
 * @brief   a scalar field of space and time on an image: the part that does not depend on the field
 *
 * The output has one point array, the active scalars, and the time in DATA_TIME_STEP. The field is
 * evaluated for the time that is asked for, whether it is one of the time steps, between them or
 * beyond them; without one, for the first time step.
 *
 * Errors (vtkErrorMacro, empty output): a time that is not finite.
 *
 * @sa vtkAnalyticFieldSource vtkTemporalGridSource
 */
class INTERLUMESOURCES_EXPORT vtkTemporalImageSource : public vtkBoundedImageSource
{
public:
  vtkAbstractTypeMacro(vtkTemporalImageSource, vtkBoundedImageSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns the field at one point and time.
   */
  double Evaluate(const double x[3], double t) const { return this->GetFieldAtTime(t)(x); }

  ///@{
  /**
   * The number of time steps, evenly spaced over the time range. One step is at its start, and
   * there is one where the range has no length. Default 3. Valid: 1 to 100000; clamped.
   */
  void SetNumberOfTimeSteps(int number) { this->Sampler.SetNumberOfTimeSteps(number, this); }
  int GetNumberOfTimeSteps() const { return this->Sampler.GetNumberOfTimeSteps(); }
  ///@}

  ///@{
  /**
   * The times of the first and the last time step, in units of time. Default 0, 2. Valid: finite,
   * else an error; put in order.
   */
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->Sampler.GetTimeRange(); }
  ///@}

  ///@{
  /**
   * The type of the array: VTK_FLOAT or VTK_DOUBLE; anything else is taken as float. Default
   * VTK_FLOAT.
   */
  void SetOutputScalarType(int type) { this->Sampler.SetScalarType(type, this); }
  int GetOutputScalarType() const { return this->Sampler.GetScalarType(); }
  ///@}

  ///@{
  /**
   * The name of the point array. Default "f", which null and an empty name stand for too.
   */
  void SetArrayName(const char* name) { this->Sampler.SetArrayName(name, this); }
  const char* GetArrayName() const { return this->Sampler.GetArrayName(); }
  ///@}

protected:
  vtkTemporalImageSource();
  ~vtkTemporalImageSource() override = default;

  /// Returns the field at time \a t, for many positions. It is called by several threads at once.
  virtual vtkFieldSampler::Field GetFieldAtTime(double t) const = 0;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTemporalImageSource(const vtkTemporalImageSource&) = delete;
  void operator=(const vtkTemporalImageSource&) = delete;

  vtkFieldSampler Sampler;
};

#endif
