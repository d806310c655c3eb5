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
 * @brief   what is found of the cells of an unstructured grid, whatever its vectors are: the tree
 * of their boxes, and which of their faces are the same
 *
 * It is found once, and used again by any filter for as long as one of them keeps it. A mesh is the
 * same when its grid, points, cells, types of cells and marks of blanking are the same objects,
 * none of them modified since; a filter that changes numbers in memory has to call Modified of
 * what it has changed, as everywhere in VTK.
 */
class MeshLinks
{
public:
  /// The objects that a mesh is made of, and when each was modified, which no two changes share.
  using Key = std::vector<std::pair<const void*, vtkMTimeType>>;
  static Key GetKey(vtkUnstructuredGrid* grid);

  /// Returns what is kept of a mesh; null without.
  static std::shared_ptr<const MeshLinks> Find(const Key& key);
  /// Lets Find know what was found, as long as somebody keeps it.
  static void Add(const Key& key, const std::shared_ptr<const MeshLinks>& links);

  /// Returns the number of outer faces that have a cell beyond them, and the first of their cells.
  /// compute() does that, once.
  template <typename Compute>
  const std::pair<vtkIdType, vtkIdType>& GetOpenInterfaces(Compute&& compute) const
  {
    std::call_once(this->OpenOnce, [&] { this->Open = compute(); });
    return this->Open;
  }

  CellTree Tree;
  int FacesPerCell = 0;
  /// For each face of each cell -1, or 64 times the neighbour, 8 times its face, twice the start
  /// and whether it is reversed.
  std::vector<vtkIdType> Links;
  FaceLinks::Joins Joins;

  /// Returns that number, for face \a face of a cell.
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
