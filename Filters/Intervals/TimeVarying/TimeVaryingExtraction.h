// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingExtraction_h
#define interlume_TimeVaryingExtraction_h

namespace interlume
{

struct TimeVaryingReport;

class TimeStep;
class TimeVaryingMesh;
struct ExtractionContext;

/**
 * @class   TimeVaryingExtraction
 * @brief   extraction of the 4-simplices between two time steps
 *
 * The points of both steps form one set. With n points, id i < n is point i at the first step, and
 * id i + n is the same point at the second step. The product of a cell and the slab is a cell of
 * the space-time table. In the global order, its corners at the first step precede those at the
 * second step. Therefore adjacent slabs match at their common step.
 */
class TimeVaryingExtraction
{
public:
  /// Adds the 4-simplices to \a mesh. Returns false if the user aborted.
  static bool Execute(const ExtractionContext& context, const TimeStep& first,
    const TimeStep& second, TimeVaryingMesh& mesh, TimeVaryingReport& report);
};

}

#endif
