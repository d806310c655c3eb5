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
 * @brief   samples a scalar field of space and time: the settings of its source, and threads
 *
 * A sampler refers to its source's settings. The functions that set one mark the \a owner modified
 * if it changes.
 */
struct FieldSampler
{
  /// A scalar field of position at one time.
  using Field = std::function<double(const double x[3])>;
  /// Computes the position of the point (i,j,k), which has id \a point in the output.
  using Positions = std::function<void(const int ijk[3], vtkIdType point, double x[3])>;

  int NumberOfTimeSteps;
  std::array<double, 2> TimeRange;
  int ScalarType;
  const char* ArrayName;

  /// Sets the range in ascending order. Returns an error if it is not finite.
  static Error SetTimeRange(double (&range)[2], double first, double last, vtkAlgorithm* owner);
  /// Sets VTK_DOUBLE, or VTK_FLOAT for any other type.
  static void SetScalarType(int& member, int type, vtkAlgorithm* owner);
  /// Sets the name, or the default for a null or empty one.
  static void SetArrayName(
    std::string& member, const char* name, const char* defaultName, vtkAlgorithm* owner);

  /// Adds the whole extent, the time steps and the array to the pipeline's information.
  void Announce(vtkInformation* output, const int wholeExtent[6]) const;

  /// Finds the requested time, or the first time step. Returns an error if it is not finite.
  Error FindTime(vtkInformation* output, double& time) const;

  /**
   * Adds the array with the field's values at the points of \a output, whose extent is \a extent,
   * as active scalars, and stores the time. Threads share the rows. Returns false if the owner's
   * execution was aborted.
   */
  bool Sample(vtkDataSet* output, const int extent[6], double time, const Field& field,
    const Positions& positions, vtkAlgorithm* owner) const;

  void Print(std::ostream& os, vtkIndent indent) const;
};

}

#endif
