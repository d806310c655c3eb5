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
 * The result of counting a chunk of cells, which the writing of the chunk uses.
 */
struct UnstructuredChunk
{
  static constexpr vtkIdType Size = 256 * ExtractionIndex::RunLength;

  /// A cell that is passed on as it is.
  struct InteriorCell
  {
    /// The index of the cell, counted from the chunk's first.
    std::uint16_t Position;
    std::uint16_t Item;
  };

  ChunkCuts Cuts;
  /// The points of all cases, where nodes are kept.
  std::vector<const CrossingLists::Node*> Nodes;
  std::vector<vtkIdType> TiedTriangles;
  std::vector<vtkIdType> TiedSimplices;
  /// The triangles that share no points.
  PointArrays::Part Unshared;
  std::vector<InteriorCell> InteriorCells;
  ///@{
  /// The numbers of what the chunk has; then of what the chunks before it have.
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
  vtkIdType Interior = 0;
  vtkIdType InteriorIds = 0;
  ///@}
  ExtractionReport Report;

  /// Returns how many cells the output has of the chunk.
  vtkIdType GetOutput() const { return this->Simplices + this->Interior; }

  std::size_t GetBytes() const
  {
    return this->Cuts.GetBytes() + this->Nodes.capacity() * sizeof(void*) +
      this->Unshared.GetBytes() + this->InteriorCells.capacity() * sizeof(InteriorCell);
  }
};

}

#endif
