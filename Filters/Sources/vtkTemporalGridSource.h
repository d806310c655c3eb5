// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalGridSource_h
#define vtkTemporalGridSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkInterlumeReport.h"     // for GetReport()
#include "vtkNew.h"                 // for the report
#include "vtkStructuredGridAlgorithm.h"

#include <functional> // for fields
#include <string>     // for the array's name

namespace interlume
{
struct FieldSampler;
}

/**
 * @class   vtkTemporalGridSource
 * @brief   a scalar field of space and time on a curvilinear grid: the part that depends on neither
 *
 * The points of the grid do not move, and are of the type of the array. The output has one point
 * array, the active scalars, and the time in DATA_TIME_STEP. The field is evaluated at the
 * requested time, or without one at the first time step. Any part of the whole extent is made
 * alone.
 *
 * Errors (vtkErrorMacro, empty output): a time that is not finite.
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
  /// The number of time steps and their range, as in vtkAnalyticFieldSource. Default 3 steps from 0
  /// to 2.
  vtkSetClampMacro(NumberOfTimeSteps, int, 1, 100000);
  int GetNumberOfTimeSteps() const { return this->NumberOfTimeSteps; }
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->TimeRange; }
  ///@}

  ///@{
  /// The type of the array and of the points: VTK_FLOAT (default) or VTK_DOUBLE.
  void SetOutputScalarType(int type);
  int GetOutputScalarType() const { return this->OutputScalarType; }
  ///@}

  ///@{
  /// The name of the point array. The default is the subclass's; null and an empty name stand for
  /// it.
  void SetArrayName(const char* name);
  const char* GetArrayName() const { return this->ArrayName.c_str(); }
  ///@}

  /// Returns the report of the last execution: Points, Evaluations (positions where the field was
  /// evaluated), Bytes (of the output) and Time. After an error or an abort all are 0.
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTemporalGridSource(const char* arrayName, int i, int j, int k);
  ~vtkTemporalGridSource() override = default;

  int GetDimension(int axis) const { return this->Dimensions[axis]; }

  /// A scalar field of position at one time.
  using Field = std::function<double(const double x[3])>;

  /// Returns the field at time \a t, for many positions. Several threads call the result.
  virtual Field GetFieldAtTime(double t) const = 0;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTemporalGridSource(const vtkTemporalGridSource&) = delete;
  void operator=(const vtkTemporalGridSource&) = delete;

  interlume::FieldSampler GetSampler() const;

  int Dimensions[3];
  int NumberOfTimeSteps = 3;
  double TimeRange[2] = { 0.0, 2.0 };
  int OutputScalarType = VTK_FLOAT;
  const char* DefaultArrayName;
  std::string ArrayName;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
