// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshedArrays_h
#define interlume_MeshedArrays_h

#include <functional>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

struct Tetrahedra;

/**
 * @class   MeshedArrays
 * @brief   the arrays of a mesh, from those of its input
 */
class MeshedArrays
{
public:
  /**
   * Makes every numeric point array, by the origins of the points: integers as float (8 and 16
   * bits) or double. Global ids, ghosts and arrays that are not numbers are left out. Returns false
   * when \a isCancelled.
   */
  static bool InterpolatePointData(vtkDataSet* input, const Tetrahedra& mesh,
    const std::function<bool()>& isCancelled, vtkUnstructuredGrid* output);

  /// Copies every cell array of the input cells, except global ids and ghosts.
  static void CopyCellData(vtkDataSet* input, const Tetrahedra& mesh, vtkUnstructuredGrid* output);
};

}

#endif
