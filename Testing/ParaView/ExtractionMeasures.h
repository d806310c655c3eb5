#ifndef ExtractionMeasures_h
#define ExtractionMeasures_h

#include <nlohmann/json.hpp>

class vtkUnstructuredGrid;

/**
 * The measures of an extraction that two builds of the same filter must agree on, as JSON:
 * `points`, `cells`, `bounds` (six, world units), `size` (volume of tetrahedra or area of
 * triangles), `arrays` (names of the point and cell arrays, sorted) and `cells_by_id` (number of
 * cells for each value of \a idArray).
 */
nlohmann::json MeasureExtraction(vtkUnstructuredGrid* grid, const char* idArray);

#endif
