// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Streamlines_h
#define interlume_Streamlines_h

#include "Advection/AdvectionOptions.h"

#include "vtkType.h"

#include <functional>
#include <vector>

namespace interlume
{

class FlowField;

/**
 * @class   Streamlines
 * @brief   interface for tracing many streamlines of one field
 *
 * If several processes hold partitions of the field, all processes must call each member in the
 * same order. Each process passes its own streamlines or positions. Follow returns the same value
 * in all processes.
 */
class Streamlines
{
public:
  virtual ~Streamlines() = default;

  /// Computes the start position of streamline \a i.
  using GetPosition = std::function<void(vtkIdType i, double x[3])>;
  /// Receives the result of streamline \a i. Threads call it concurrently for different
  /// streamlines.
  using Take = std::function<void(vtkIdType i, const AdvectionResult& result)>;
  /// Traces \a number streamlines while the progress advances from \a begin to \a end. Returns
  /// false if the execution was aborted.
  virtual bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) = 0;

  /// Velocity at a position, and the length of the vorticity vector if requested; 0 outside the
  /// field.
  struct Velocity
  {
    bool IsInField = false;
    double V[3] = { 0.0, 0.0, 0.0 };
    double Vorticity = 0.0;
  };
  virtual std::vector<Velocity> GetVelocities(
    vtkIdType number, const GetPosition& position, bool withVorticity) = 0;

  /// Returns the field, or this process's partition of it. Speeds and bounds are those of the whole
  /// field.
  virtual const FlowField& GetField() const = 0;
};

}

#endif
