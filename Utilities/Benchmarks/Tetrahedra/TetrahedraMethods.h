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
 * The ways of vtkTimeWeightedTetrahedraMapper that the suite `tetrahedra` measures.
 */
namespace tetrahedra
{
/// The name of the peer in every row.
extern const char* const Peer;

struct RenderPath
{
  /// The method of a row.
  const char* Name;
  int Path;
};
const std::vector<RenderPath>& AllRenderPaths();

struct RenderMode
{
  /// The parameter of a row.
  const char* Name;
  int Blend;
  int Sort;
  int Integration;
};
/// Modes without a sort.
extern const char* const Unsorted;
extern const char* const OpticalDepth;

const std::vector<RenderMode>& AllRenderModes();
/// The mode with every default of the mapper.
const RenderMode& GetDefaultMode();

/// A mapper with that path and mode, without level of detail.
vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> NewMapper(
  vtkUnstructuredGrid* grid, const RenderPath& path, const RenderMode& mode);

/// Adds counts of the mapper's last picture: tetrahedra, passes, sort, bytes.
void AddReport(vtkInterlumeReport* report, BenchRow& row);
}

#endif
