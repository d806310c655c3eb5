// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBlocks_h
#define ReferenceBlocks_h

#include "Support/Meshes/ReferenceMesh.h" // for the kinds of meshes

#include "vtkSmartPointer.h" // for the blocks

#include <array>  // for the blocks
#include <set>    // for the faces
#include <vector> // for points

class vtkDataArray;
class vtkUnstructuredGrid;

namespace reference
{

/// How ids of points are stored.
struct IdStorage
{
  int Type;         ///< one of VTK's, or VTK_VOID for no ids
  bool IsInColumns; ///< as a vtkSOADataArrayTemplate of long long
};

/// Every integer type that holds the ids of MakeBlocks.
std::vector<IdStorage> AllIdStorages();

/**
 * Two blocks of a mesh of 2 x 2 x 2 boxes that meet in the plane where a coordinate is 1. Each has
 * an order of its own of its points, by \a seed, and global ids. The point array `f` is the
 * distance from the plane.
 */
std::array<vtkSmartPointer<vtkUnstructuredGrid>, 2> MakeBlocks(
  MeshKind kind, int axis, unsigned int seed, const IdStorage& ids);

/// The faces of simplices that lie in the plane between blocks, by the coordinates of their points;
/// the fourth one is that of the point array `Time`, if there is one.
std::multiset<std::vector<std::array<double, 4>>> FacesBetweenBlocks(
  vtkUnstructuredGrid* simplices, int axis);

}

#endif
