// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzData_h
#define FuzzData_h

#include "FuzzRandom.h" // for choices

#include "vtkSmartPointer.h" // for the data

#include <string> // for the description

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkUnstructuredGrid;

/**
 * Datasets at random: of every type, with mixed, degenerate, repeated and inverted cells, ghost and
 * blank flags, numbers that are none, tiny, huge or tied, odd extents, and nothing at all.
 */
namespace fuzz
{

struct FuzzData
{
  vtkSmartPointer<vtkDataSet> Data;
  /// Cells are convex with planar faces, coordinates of moderate size, values finite; nothing is
  /// hidden, degenerate or twice there. Volumes then add up.
  bool IsTame = true;
  std::string Text; ///< what it is, for a message
};

/// A dataset of any type with a point array `f` of one component, the active scalars, and sometimes
/// a cell array `c`.
FuzzData MakeData(FuzzRandom& random);

/// An image of a few cells with `f`.
FuzzData MakeImage(FuzzRandom& random);

/// Unstructured tetrahedra with `f`, sometimes degenerate, inverted or apart.
FuzzData MakeTetrahedra(FuzzRandom& random);

/// Adds a point array `v` of three components, smooth or not, and makes it the active vectors.
void AddVectors(FuzzRandom& random, FuzzData& data);

/// A bound near, among or at the values of an array, or an extreme one.
double MakeBound(FuzzRandom& random, vtkDataArray* values);

}

#endif
