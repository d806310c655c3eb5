// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredChunk_h
#define interlume_UnstructuredChunk_h

#include "Output/ExtractionReport.h"
#include "Arrays/PointArrays.h"
#include "Pass/ExtractionIndex.h"
#include "Unstructured/ChunkCuts.h"
#include "Unstructured/CrossingLists.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * Result of counting the output of a chunk of cells, used to write the chunk.
 */
struct UnstructuredChunk
{
  static constexpr vtkIdType Size = 256 * ExtractionIndex::RunLength;

  /// A cell that is copied uncut.
  struct InteriorCell
  {
    /// Index of the cell in the chunk.
    std::uint16_t Position;
    std::uint16_t Item;
  };

  ChunkCuts Cuts;
  /// The nodes of the points of all cuts, if nodes are kept.
  std::vector<const CrossingLists::Node*> Nodes;
  std::vector<vtkIdType> TiedTriangles;
  std::vector<vtkIdType> TiedSimplices;
  /// The triangles, if they share no points.
  PointArrays::Part Unshared;
  std::vector<InteriorCell> InteriorCells;
  ///@{
  /// Counts of this chunk, later replaced with the sums over all previous chunks.
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
  vtkIdType Interior = 0;
  vtkIdType InteriorIds = 0;
  ///@}
  ExtractionReport Report;

  /// Returns the number of output cells of the chunk.
  vtkIdType GetOutput() const { return this->Simplices + this->Interior; }

  std::size_t GetBytes() const
  {
    return this->Cuts.GetBytes() + this->Nodes.capacity() * sizeof(void*) +
      this->Unshared.GetBytes() + this->InteriorCells.capacity() * sizeof(InteriorCell);
  }
};

}

#endif
