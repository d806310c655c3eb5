#ifndef vtkMeshedArrays_h
#define vtkMeshedArrays_h

#include <functional>

class vtkDataSet;
class vtkUnstructuredGrid;
struct vtkTetrahedra;

/**
 * @class   vtkMeshedArrays
 * @brief   the arrays of a mesh, from those of its input
 */
class vtkMeshedArrays
{
public:
  /**
   * Every numeric point array, by the origins of the points: integers as float (8 and 16 bits) or
   * double. Global ids, ghosts and arrays that are not numbers are left out. Returns false when
   * \a isCancelled.
   */
  static bool InterpolatePointData(vtkDataSet* input, const vtkTetrahedra& mesh,
    const std::function<bool()>& isCancelled, vtkUnstructuredGrid* output);

  /// Every cell array of the input cells, except global ids and ghosts.
  static void CopyCellData(
    vtkDataSet* input, const vtkTetrahedra& mesh, vtkUnstructuredGrid* output);
};

#endif
