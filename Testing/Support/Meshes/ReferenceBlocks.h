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

/// Storage of global point ids.
struct IdStorage
{
  int Type;         ///< a VTK type, or VTK_VOID for no ids
  bool IsInColumns; ///< if true, a vtkSOADataArrayTemplate of long long
};

/// Returns every integer type that can store the ids of MakeBlocks().
std::vector<IdStorage> AllIdStorages();

/**
 * Returns two blocks of a mesh of 2 x 2 x 2 boxes. The blocks meet in the plane where the
 * coordinate \a axis is 1. Their points are numbered separately, in a random order given by \a
 * seed, and have global ids. The point array `f` is the distance from the plane.
 */
std::array<vtkSmartPointer<vtkUnstructuredGrid>, 2> MakeBlocks(
  MeshKind kind, int axis, unsigned int seed, const IdStorage& ids);

/// Returns the faces of simplices in the plane between blocks, as sorted point coordinates. The
/// fourth coordinate is the point array `Time` if it exists, otherwise 0.
std::multiset<std::vector<std::array<double, 4>>> FacesBetweenBlocks(
  vtkUnstructuredGrid* simplices, int axis);

}

#endif
