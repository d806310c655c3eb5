// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraBuilder_h
#define interlume_TetrahedraBuilder_h

#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"

#include <string>

class vtkDataArray;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace interlume
{

/**
 * The arrays of a grid that are read; null where there is none.
 */
struct TetrahedraArrays
{
  vtkDataArray* Scalars = nullptr;
  bool ScalarsAreOfCells = false;
  vtkDataArray* DeltaT = nullptr;
  vtkDataArray* Layers = nullptr;
};

/**
 * @class   TetrahedraBuilder
 * @brief   makes the mesh and the fields that are drawn from a grid and its arrays
 *
 * Each function returns what is wrong, or nothing.
 */
class TetrahedraBuilder
{
public:
  struct Counts
  {
    vtkIdType Flat = 0;
    vtkIdType NonFinite = 0;
  };

  /**
   * Makes the mesh without flat tetrahedra, ghosts, and those with NaN or infinity in a coordinate
   * or array.
   */
  static std::string BuildMesh(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays,
    TetrahedraMesh& mesh, Counts& counts);

  /**
   * Makes all fields but colours that transfer functions give.
   */
  static void BuildFields(
    const TetrahedraArrays& arrays, const TetrahedraMesh& mesh, TetrahedraFields& fields);

  /**
   * Makes kind, scalars, and colours where they are not looked up while drawing. Extinction is
   * opacity times \a unit.
   */
  static std::string BuildColors(const TetrahedraArrays& arrays, const TetrahedraMesh& mesh,
    vtkVolumeProperty* property, double unit, TetrahedraFields& fields);

  /**
   * Returns the component that colours, or -1 for the magnitude of a vector.
   */
  static int GetColoringComponent(vtkDataArray* scalars, vtkVolumeProperty* property);
};

}

#endif
