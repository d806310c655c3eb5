// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalGridSource_h
#define vtkTemporalGridSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkFieldSampler.h"        // for the time steps and the array
#include "vtkSourceReport.h"        // for the report
#include "vtkStructuredGridAlgorithm.h"

/**
 * @class   vtkTemporalGridSource
 * @brief   a scalar field of space and time on a curvilinear grid: the part that depends on neither
 *
 * This is vtkTemporalImageSource for a grid whose points do not move: one point array, any time,
 * any part of the whole extent, the same error. Points are of the type of the array.
 *
 * @sa vtkTaperedCylinderSource vtkDeltaWingSource
 */
class INTERLUMESOURCES_EXPORT vtkTemporalGridSource : public vtkStructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkTemporalGridSource, vtkStructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns the field at one point and time.
  double Evaluate(const double x[3], double t) const { return this->GetFieldAtTime(t)(x); }

  /// Computes the position of the grid's point (i,j,k), before it is rounded to the type of the
  /// points.
  virtual void GetPosition(const int ijk[3], double x[3]) const = 0;

  ///@{
  /**
   * The number of points in each direction. The default is the subclass's. Valid: 2 to 32768;
   * clamped.
   */
  void SetDimensions(int i, int j, int k);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /// The number of time steps and their range, as in vtkTemporalImageSource. Default 3 steps from 0
  /// to 2.
  void SetNumberOfTimeSteps(int number) { this->Sampler.SetNumberOfTimeSteps(number, this); }
  int GetNumberOfTimeSteps() const { return this->Sampler.GetNumberOfTimeSteps(); }
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->Sampler.GetTimeRange(); }
  ///@}

  ///@{
  /// The type of the array and of the points: VTK_FLOAT (default) or VTK_DOUBLE.
  void SetOutputScalarType(int type) { this->Sampler.SetScalarType(type, this); }
  int GetOutputScalarType() const { return this->Sampler.GetScalarType(); }
  ///@}

  ///@{
  /// The name of the point array. The default is the subclass's; null and an empty name stand for
  /// it.
  void SetArrayName(const char* name) { this->Sampler.SetArrayName(name, this); }
  const char* GetArrayName() const { return this->Sampler.GetArrayName(); }
  ///@}

  /// Returns what the last execution took.
  const vtkSourceReport& GetReport() const { return this->Report; }

protected:
  vtkTemporalGridSource(const char* arrayName, int i, int j, int k);
  ~vtkTemporalGridSource() override = default;

  int GetDimension(int axis) const { return this->Dimensions[axis]; }

  /// The field at time \a t, for many positions. It is called by several threads at once.
  virtual vtkFieldSampler::Field GetFieldAtTime(double t) const = 0;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTemporalGridSource(const vtkTemporalGridSource&) = delete;
  void operator=(const vtkTemporalGridSource&) = delete;

  int Dimensions[3];
  vtkFieldSampler Sampler;
  vtkSourceReport Report;
};

#endif
