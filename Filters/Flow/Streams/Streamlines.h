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
 * @brief   follows many streamlines of one field
 *
 * Where the field is held in parts by several processes, all of them call each member, in the same
 * order, each with streamlines of its own, and get the same returned.
 */
class Streamlines
{
public:
  virtual ~Streamlines() = default;

  /// Computes the position with number \a i.
  using GetPosition = std::function<void(vtkIdType i, double x[3])>;
  /// Takes the result of the streamline with number \a i. Threads call it at once for different
  /// ones.
  using Take = std::function<void(vtkIdType i, const AdvectionResult& result)>;
  /// Follows a number of streamlines while the progress goes from \a begin to \a end. Returns false
  /// when the execution was aborted.
  virtual bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) = 0;

  /// The velocity somewhere.
  struct Velocity
  {
    bool IsInField = false;
    double V[3] = { 0.0, 0.0, 0.0 };
  };
  virtual std::vector<Velocity> GetVelocities(vtkIdType number, const GetPosition& position) = 0;

  /// Returns what is known of the field as a whole.
  virtual const FlowField& GetField() const = 0;
};

}

#endif
