// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExtractionMeasures_h
#define ExtractionMeasures_h

#include <nlohmann/json.hpp>

class vtkUnstructuredGrid;

/**
 * The measures of an extraction that two builds of the same filter must agree on, as JSON:
 * `points`, `cells`, `bounds` (six, world units), `size` (area of triangles, volume of tetrahedra,
 * or hypervolume of cells of five points with the point array `Time`; the sum over the cells, with
 * their signs), `hypervolume` (the integral of the point array `DeltaT` over the tetrahedra, 0
 * without one), `ranges` (of the first component of each point and cell array, by name) and `by_id`
 * (`id`, `cells` and `size` for each value of \a idArray).
 */
nlohmann::json MeasureExtraction(vtkUnstructuredGrid* grid, const char* idArray);

#endif
