// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFieldSampler_h
#define vtkFieldSampler_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkIndent.h"              // for Print
#include "vtkType.h"                // for the scalar type

#include <array>      // for the time range
#include <functional> // for fields
#include <string>     // for the name

class vtkAlgorithm;
class vtkDataSet;
class vtkInformation;

/**
 * @class   vtkFieldSampler
 * @brief   what temporal sources have in common: time steps, scalar array, threaded sampling
 *
 * A setter marks its \a owner modified when it changes anything.
 */
class INTERLUMESOURCES_EXPORT vtkFieldSampler
{
public:
  /// A scalar field of position at one time.
  using Field = std::function<double(const double x[3])>;
  /// Gives the position of the point (i,j,k), which has id \a point in the output.
  using Positions = std::function<void(const int ijk[3], vtkIdType point, double x[3])>;

  static constexpr int MaximumNumberOfTimeSteps = 100000;

  explicit vtkFieldSampler(const char* arrayName)
    : DefaultArrayName(arrayName)
    , ArrayName(arrayName)
  {
  }

  void SetNumberOfTimeSteps(int number, vtkAlgorithm* owner);
  int GetNumberOfTimeSteps() const { return this->NumberOfTimeSteps; }
  /// Returns why the range is not taken, or nothing.
  std::string SetTimeRange(double first, double last, vtkAlgorithm* owner);
  const double* GetTimeRange() const { return this->TimeRange.data(); }
  void SetScalarType(int type, vtkAlgorithm* owner);
  int GetScalarType() const { return this->ScalarType; }
  void SetArrayName(const char* name, vtkAlgorithm* owner);
  const char* GetArrayName() const { return this->ArrayName.c_str(); }

  /// Tells the pipeline of the whole extent, the time steps and the array.
  void Announce(vtkInformation* output, const int wholeExtent[6]) const;

  /// Finds the time that is asked for, or the first time step. Returns what is wrong with it, or
  /// nothing.
  std::string FindTime(vtkInformation* output, double& time) const;

  /**
   * Adds the array with the field's values at the points of \a output, whose extent is \a extent,
   * as active scalars, and notes the time. Threads share the rows. Returns false when the owner's
   * execution was aborted.
   */
  bool Sample(vtkDataSet* output, const int extent[6], double time, const Field& field,
    const Positions& positions, vtkAlgorithm* owner) const;

  void Print(ostream& os, vtkIndent indent) const;

private:
  std::string DefaultArrayName;
  std::string ArrayName;
  int NumberOfTimeSteps = 3;
  std::array<double, 2> TimeRange{ { 0.0, 2.0 } };
  int ScalarType = VTK_FLOAT;
};

#endif
