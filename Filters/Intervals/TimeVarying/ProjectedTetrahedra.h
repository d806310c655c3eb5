// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ProjectedTetrahedra_h
#define interlume_ProjectedTetrahedra_h

#include "Pass/ExtractionContext.h"
#include "TimeVarying/SimplexProjection.h"
#include "TimeVarying/TimeVaryingMesh.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

struct TimeVaryingReport;

/**
 * @class   ProjectedTetrahedra
 * @brief   makes the tetrahedra of all projections, with the points of a mesh and thick points
 *
 * A thick point is a point of its own for each 4-simplex that is not flat. In the first pass each
 * 4-simplex is projected, its thick point is written, and the signs are kept, of which the second
 * pass makes tetrahedra once it is known how many come before. Thick points are written as if no
 * 4-simplex were flat; where any is, the others are moved up.
 */
class ProjectedTetrahedra
{
public:
  ProjectedTetrahedra(
    const ExtractionContext& context, const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output);
  ~ProjectedTetrahedra();

  /// Fills the output. Returns false when the user aborted. The counts of what is made are added to
  /// the report.
  bool Fill(TimeVaryingReport& report);

private:
  using Simplex = TimeVaryingMesh::Simplex;
  using Slab = TimeVaryingMesh::Slab;

  struct Block;
  struct Batch;
  // Writes the mean of an array at the thick points of a batch.
  using MeanWriter = std::function<void(const Batch&)>;

  void MakeBlocks();
  void AllocatePoints();
  vtkSmartPointer<vtkAbstractArray> MakeArray(vtkAbstractArray* from);
  template <typename Value>
  void AddMeans(Value* values, int components);
  template <typename Value>
  void CopyPoints(Value* values);
  void ProjectBlock(Block& block);
  template <typename Value>
  void WritePoints(const Batch& batch, Value* values) const;
  void Place(Block& block, TimeVaryingReport& report);
  void LeaveOutFlat();
  void AllocateTetrahedra();
  void WriteBlock(const Block& block);
  void FillOthers();

  const ExtractionContext& Context;
  const TimeVaryingMesh& Mesh;
  vtkUnstructuredGrid* Output;
  vtkIdType BasePoints;
  vtkIdType Simplices = 0;
  vtkIdType ThickPoints = 0;
  vtkIdType Tetrahedra = 0;
  std::vector<Block> Blocks;
  // Of each simplex, all zero where it is flat.
  ExtractionBuffer<SimplexSigns> Signs;
  vtkSmartPointer<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Thickness;
  std::vector<MeanWriter> Means;
  // Arrays of values that have no mean, and the place of the heaviest point of each simplex.
  std::vector<vtkAbstractArray*> Others;
  ExtractionBuffer<std::uint8_t> Heaviest;
  SimplexList Cells;
  unsigned char* Classes = nullptr;
  int* Items = nullptr;
  int* Slabs = nullptr;
};

}

#endif
