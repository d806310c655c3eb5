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
 * @brief   base class of sources of time-dependent scalar fields on curvilinear grids
 *
 * The points do not move, and their data type is that of the array. The output has one point array,
 * the active scalars, and the time in DATA_TIME_STEP. The field is evaluated at the requested time,
 * or at the first time step if no time is requested. Any part of the whole extent can be produced.
 *
 * Errors (vtkErrorMacro, empty output): the requested time is not finite.
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

  /// Computes the position of point (i,j,k), before conversion to the type of the points.
  virtual void GetPosition(const int ijk[3], double x[3]) const = 0;

  ///@{
  /**
   * Set/Get the number of points in each direction. The default depends on the subclass. Valid: 2
   * to 32768; clamped.
   */
  void SetDimensions(int i, int j, int k);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /// Set/Get the number of time steps and their range, as in vtkAnalyticFieldSource. Default 3
  /// steps from 0 to 2.
  vtkSetClampMacro(NumberOfTimeSteps, int, 1, 100000);
  int GetNumberOfTimeSteps() const { return this->NumberOfTimeSteps; }
  void SetTimeRange(double first, double last);
  const double* GetTimeRange() const VTK_SIZEHINT(2) { return this->TimeRange; }
  ///@}

  ///@{
  /// Set/Get the type of the array and of the points: VTK_FLOAT (default) or VTK_DOUBLE.
  void SetOutputScalarType(int type);
  int GetOutputScalarType() const { return this->OutputScalarType; }
  ///@}

  ///@{
  /// Set/Get the name of the point array. The default depends on the subclass; a null or empty name
  /// restores it.
  void SetArrayName(const char* name);
  const char* GetArrayName() const { return this->ArrayName.c_str(); }
  ///@}

  /// Returns the report of the last execution: Points, Evaluations (number of positions where the
  /// field was evaluated), Bytes (size of the output) and Time. All are 0 after an error or abort.
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTemporalGridSource(const char* arrayName, int i, int j, int k);
  ~vtkTemporalGridSource() override = default;

  int GetDimension(int axis) const { return this->Dimensions[axis]; }

  /// A scalar field at one time, as a function of the position.
  using Field = std::function<double(const double x[3])>;

  /// Returns the field at time \a t. Several threads may call the result concurrently.
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
