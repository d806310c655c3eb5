// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/DrawingGrowth.h"
#include "Benchmarks/Growth/ExtractionGrowth.h"
#include "Benchmarks/Growth/FlowGrowth.h"
#include "Benchmarks/Growth/TimeGrowth.h"

namespace growth
{
std::vector<Quantity> MakeQuantities(const BenchOptions& options)
{
  std::vector<Quantity> made = { MakeCells(options), MakeContour(options), MakeSimplices(options),
    MakeCellsInTime(options), MakeSteps(options), MakeWrittenSteps(options) };
  for (const tetrahedra::RenderPath& path : tetrahedra::AllRenderPaths())
  {
    made.push_back(MakeTetrahedra(options, path));
  }
  made.push_back(MakeSlices(options));
  made.push_back(MakeLights(options));
  made.push_back(MakeSamples(options));
  made.push_back(MakeThreads(options));
  return made;
}
}
