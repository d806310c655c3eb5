// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshLinks_h
#define interlume_MeshLinks_h

#include "Cells/CellTree.h"
#include "Fields/FaceLinks.h"

#include "vtkType.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   MeshLinks
 * @brief   cell tree and face links of an unstructured grid, independent of its vectors
 *
 * The links are computed once and reused by all filters as long as one filter holds a reference.
 * Two meshes are the same if the grid, points, cells, cell types and ghost arrays are the same
 * objects with unchanged modification times. Code that changes values in memory must therefore call
 * Modified(), as usual in VTK.
 */
class MeshLinks
{
public:
  /// Objects of a mesh and their modification times. Modification times are unique within a
  /// process.
  using Key = std::vector<std::pair<const void*, vtkMTimeType>>;
  static Key GetKey(vtkUnstructuredGrid* grid);

  /// Returns the links of a mesh, or null if there are none.
  static std::shared_ptr<const MeshLinks> Find(const Key& key);
  /// Makes the links available to Find() as long as a reference to them exists.
  static void Add(const Key& key, const std::shared_ptr<const MeshLinks>& links);

  /// Returns the number of faces that NonconformingInterfaces counts, and the cell id of the first
  /// one, or -1. The first call computes both with compute(), and later calls return the same
  /// values.
  template <typename Compute>
  const std::pair<vtkIdType, vtkIdType>& GetNonconformingInterfaces(Compute&& compute) const
  {
    std::call_once(this->OpenOnce, [&] { this->Open = compute(); });
    return this->Open;
  }

  CellTree Tree;
  int FacesPerCell = 0;
  /// For each face of each cell: -1 if there is no neighbor, otherwise the code from GetLink().
  std::vector<vtkIdType> Links;
  FaceLinks::MatchGaps Gaps;

  /// Encodes a link to face \a face of a cell as 64 * cell + 8 * face + 2 * start + reversed.
  static vtkIdType GetLink(vtkIdType cell, int face, const FaceLinks::Link& link)
  {
    return 64 * cell + 8 * face + 2 * link.Start + (link.IsReversed ? 1 : 0);
  }

private:
  mutable std::once_flag OpenOnce;
  mutable std::pair<vtkIdType, vtkIdType> Open{ 0, -1 };
};

}

#endif
