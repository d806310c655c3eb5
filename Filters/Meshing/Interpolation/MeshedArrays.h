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
 * @brief   computes the arrays of a tetrahedral mesh from the arrays of the input
 */
class MeshedArrays
{
public:
  /**
   * Interpolates each numeric point array from the source points. 8-bit and 16-bit integers become
   * float, other integers become double. Global ids, pedigree ids, ghost arrays and non-numeric
   * arrays are not copied. Returns false if \a isCanceled returns true.
   */
  static bool InterpolatePointData(vtkDataSet* input, const Tetrahedra& mesh,
    const std::function<bool()>& isCanceled, vtkUnstructuredGrid* output);

  /// Copies each cell array from the input cells, except ids and ghost arrays.
  static void CopyCellData(vtkDataSet* input, const Tetrahedra& mesh, vtkUnstructuredGrid* output);
};

}

#endif
