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
 * Random datasets of every type. They have mixed, degenerate, repeated and inverted cells, ghost
 * and blanking flags, NaN, tiny, huge or tied values, and unusual or empty extents.
 */
namespace fuzz
{

struct FuzzData
{
  vtkSmartPointer<vtkDataSet> Data;
  /// True if cells are convex with planar faces, and all coordinates and values are finite and of
  /// moderate size. No cell is hidden, degenerate or duplicated. Volumes of tame data must add up.
  bool IsTame = true;
  std::string Text; ///< description for messages
};

/// Creates a dataset of any type with a one-component point array `f`, the active scalars. It may
/// also have a cell array `c`.
FuzzData MakeData(FuzzRandom& random);

/// Creates an image of a few cells with the point array `f`.
FuzzData MakeImage(FuzzRandom& random);

/// Creates tetrahedra, which may be degenerate, inverted or disconnected, with the point array `f`.
FuzzData MakeTetrahedra(FuzzRandom& random);

/// Adds a three-component point array `v` as the active vectors, smooth or random.
void AddVectors(FuzzRandom& random, FuzzData& data);

/// Returns an interval bound that equals a value of the array, is close to one or between two, or
/// is an extreme number.
double MakeBound(FuzzRandom& random, vtkDataArray* values);

}

#endif
