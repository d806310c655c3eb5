#include "SceneReport.h"

#include <nlohmann/json.hpp>

namespace gallery
{
nlohmann::json ToJson(const SceneReport& report)
{
  const vtkExtractionReport& extraction = report.Extraction;
  return { { "id", report.Id }, { "figure", report.Figure },
    { "size", { report.Width, report.Height } },
    { "seconds", report.BuildSeconds + report.RenderSeconds },
    { "build_seconds", report.BuildSeconds }, { "extract_seconds", report.ExtractSeconds },
    { "render_seconds", report.RenderSeconds }, { "features", report.Features },
    { "panels", report.Panels }, { "passes", report.Passes }, { "buffers", report.Buffers },
    { "bytes", report.Bytes }, { "filters", report.Filters }, { "intervals", report.Intervals },
    { "criteria", report.Criteria }, { "tetrahedra", report.Tetrahedra },
    { "boundary_triangles", report.BoundaryTriangles },
    { "extraction",
      { { "cells", extraction.Cells }, { "cells_visited", extraction.CellsVisited },
        { "cells_with_output", extraction.CellsWithOutput },
        { "lower_dimensional_cells", extraction.LowerDimensionalCells },
        { "non_finite_cells", extraction.NonFiniteCells },
        { "blanked_cells", extraction.BlankedCells },
        { "linearized_cells", extraction.LinearizedCells },
        { "unsupported_cells", extraction.UnsupportedCells },
        { "collapsed_simplices", extraction.CollapsedSimplices },
        { "arrays_interpolated", extraction.ArraysInterpolated },
        { "arrays_copied", extraction.ArraysCopied }, { "passes", extraction.Passes },
        { "working_bytes", extraction.WorkingBytes } } } };
}
}
