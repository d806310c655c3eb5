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
 * @brief   creates the tetrahedra of all projected 4-simplices
 *
 * The output has the points of a mesh, followed by one thick point per 4-simplex that is not
 * degenerate (see SimplexProjection). The first pass projects each 4-simplex, writes its thick
 * point and stores its signs. The second pass generates the tetrahedra from the signs. Each block
 * of 4-simplices has room for one thick point per 4-simplex. If some are degenerate, the gaps
 * between the blocks are removed afterward.
 */
class ProjectedTetrahedra
{
public:
  ProjectedTetrahedra(
    const ExtractionContext& context, const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output);
  ~ProjectedTetrahedra();

  /// Fills the output and adds the counts to the report. Returns false if the user aborted.
  bool Fill(TimeVaryingReport& report);

  /// Returns the number of tetrahedra of the last slab of a mesh, estimated from some of its
  /// 4-simplices. Returns 0 if tetrahedra are not requested.
  static double EstimateNumber(const TimeVaryingMesh& mesh);

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
  void ConvertCountsToOffsets(Block& block, TimeVaryingReport& report);
  void RemoveGaps();
  void AllocateTetrahedra();
  void WriteBlock(const Block& block);
  void FillNonNumericArrays();

  const ExtractionContext& Context;
  const TimeVaryingMesh& Mesh;
  vtkUnstructuredGrid* Output;
  vtkIdType BasePoints;
  vtkIdType Simplices = 0;
  vtkIdType ThickPoints = 0;
  vtkIdType Tetrahedra = 0;
  std::vector<Block> Blocks;
  // The signs of the affine dependency of each simplex, all zero for a degenerate simplex.
  ExtractionBuffer<SimplexSigns> Signs;
  vtkSmartPointer<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Thickness;
  std::vector<MeanWriter> Means;
  // Arrays whose values cannot be averaged.
  std::vector<vtkAbstractArray*> Others;
  // For each simplex, the index of its point with the largest weight; used for Others.
  ExtractionBuffer<std::uint8_t> Heaviest;
  SimplexList Cells;
  unsigned char* Classes = nullptr;
  int* Items = nullptr;
  int* Slabs = nullptr;
};

}

#endif
