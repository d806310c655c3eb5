// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldSampler_h
#define interlume_FieldSampler_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <iosfwd>
#include <string>

class vtkAlgorithm;
class vtkDataSet;
class vtkIndent;
class vtkInformation;

namespace interlume
{

/**
 * @class   FieldSampler
 * @brief   samples a time-dependent scalar field in parallel, with the settings of a source filter
 *
 * The static functions assign a setting of the source filter \a owner and mark it as modified if
 * the setting changes.
 */
struct FieldSampler
{
  /// A scalar field at one time, as a function of the position.
  using Field = std::function<double(const double x[3])>;
  /// Computes the position of point (i,j,k), whose id in the output is \a point.
  using Positions = std::function<void(const int ijk[3], vtkIdType point, double x[3])>;

  int NumberOfTimeSteps;
  std::array<double, 2> TimeRange;
  int ScalarType;
  const char* ArrayName;

  /// Assigns the time range in ascending order. Returns an error if a time is not finite.
  static Error SetTimeRange(double (&range)[2], double first, double last, vtkAlgorithm* owner);
  /// Assigns VTK_DOUBLE, or VTK_FLOAT for any other type.
  static void SetScalarType(int& member, int type, vtkAlgorithm* owner);
  /// Assigns the name, or the default if the name is null or empty.
  static void SetArrayName(
    std::string& member, const char* name, const char* defaultName, vtkAlgorithm* owner);

  /// Sets the whole extent, the time steps and the active scalars in the pipeline information.
  void FillInformation(vtkInformation* output, const int wholeExtent[6]) const;

  /// Finds the requested time, or the first time step. Returns an error if the time is not finite.
  Error FindTime(vtkInformation* output, double& time) const;

  /**
   * Samples the field at the points of \a output, whose extent is \a extent. Adds the array as
   * active scalars and sets the time. Returns false if the execution of \a owner was aborted.
   */
  bool Sample(vtkDataSet* output, const int extent[6], double time, const Field& field,
    const Positions& positions, vtkAlgorithm* owner) const;

  void Print(std::ostream& os, vtkIndent indent) const;
};

}

#endif
