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
 * @brief   the 4-simplices between two time steps
 *
 * The points of both steps are one set: with n points, id i < n is point i at the first step, i + n
 * that point at the second. Each cell times the slab is a cell of the table, its corners at the
 * first step before those at the second in the global order, so that slabs agree on the step they
 * share.
 */
class TimeVaryingExtraction
{
public:
  /// Adds the 4-simplices to \a mesh. Returns false when the user aborted.
  static bool Execute(const ExtractionContext& context, const TimeStep& first,
    const TimeStep& second, TimeVaryingMesh& mesh, TimeVaryingReport& report);
};

}

#endif
