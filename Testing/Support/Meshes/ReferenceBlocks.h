// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBlocks_h
#define ReferenceBlocks_h

#include "Support/Meshes/ReferenceMesh.h" // for MeshKind

#include "vtkSmartPointer.h" // for the blocks

#include <array>  // for the blocks
#include <set>    // for the faces
#include <vector> // for points and storage types

class vtkDataArray;
class vtkUnstructuredGrid;

namespace reference
{

/// Data type and memory layout of the global point ids.
struct IdStorage
{
  int Type;         ///< a VTK type, or VTK_VOID for no ids
  bool IsInColumns; ///< if true, a vtkSOADataArrayTemplate of long long
};

/// Returns all data types and memory layouts that can store the ids of MakeBlocks().
std::vector<IdStorage> AllIdStorages();

/**
 * Returns a mesh of 2 x 2 x 2 boxes in two blocks, which meet in the plane where the coordinate
 * along \a axis is 1. Each block has its own point ids, in a random order given by \a seed, and
 * global ids of the points. The point array `f` is the distance from the plane.
 */
std::array<vtkSmartPointer<vtkUnstructuredGrid>, 2> MakeBlocks(
  MeshKind kind, int axis, unsigned int seed, const IdStorage& ids);

/// Returns the faces of simplices that lie in the plane between the blocks, as sorted point
/// coordinates. The fourth coordinate is the point array `Time` if it exists, otherwise 0.
std::multiset<std::vector<std::array<double, 4>>> FacesBetweenBlocks(
  vtkUnstructuredGrid* simplices, int axis);

}

#endif
