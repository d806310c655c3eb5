// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraMethods_h
#define TetrahedraMethods_h

#include "Benchmarks/Results/BenchRow.h"

#include "vtkSmartPointer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

/**
 * Configurations of vtkTimeWeightedTetrahedraMapper in the suite `tetrahedra`.
 */
namespace tetrahedra
{
/// Name of the baseline of all rows.
extern const char* const Baseline;

struct RenderPath
{
  /// Name, stored as the method of rows.
  const char* Name;
  int Path;
};
const std::vector<RenderPath>& AllRenderPaths();

struct RenderMode
{
  /// Name, stored as the parameter of rows.
  const char* Name;
  int Blend;
  int Sort;
  int Integration;
};
/// Names of modes without sorting.
extern const char* const Unsorted;
extern const char* const OpticalDepth;

const std::vector<RenderMode>& AllRenderModes();
/// Returns the mode in which all settings have the mapper's defaults.
const RenderMode& GetDefaultMode();

/// Returns a mapper with this render path and mode. Level of detail is off.
vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> NewMapper(
  vtkUnstructuredGrid* grid, const RenderPath& path, const RenderMode& mode);

/// Adds the counts of the last frame, such as tetrahedra, passes and bytes, from \a report to
/// \a row.
void AddReport(vtkInterlumeReport* report, BenchRow& row);
}

#endif
