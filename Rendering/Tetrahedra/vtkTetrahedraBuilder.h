#ifndef vtkTetrahedraBuilder_h
#define vtkTetrahedraBuilder_h

#include "vtkTetrahedraFields.h"
#include "vtkTetrahedraMesh.h"

#include <string>

class vtkDataArray;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

/**
 * The arrays of a grid that are read; null where there is none.
 */
struct vtkTetrahedraArrays
{
  vtkDataArray* Scalars = nullptr;
  bool ScalarsAreOfCells = false;
  vtkDataArray* DeltaT = nullptr;
  vtkDataArray* Layers = nullptr;
};

/**
 * @class   vtkTetrahedraBuilder
 * @brief   from a grid and its arrays to what is drawn
 *
 * Each function returns what is wrong, or nothing.
 */
class vtkTetrahedraBuilder
{
public:
  struct Counts
  {
    vtkIdType Flat = 0;
    vtkIdType NonFinite = 0;
  };

  /**
   * The mesh without flat tetrahedra, ghosts, and those with NaN or infinity in a coordinate or
   * array.
   */
  static std::string BuildMesh(vtkUnstructuredGrid* grid, const vtkTetrahedraArrays& arrays,
    vtkTetrahedraMesh& mesh, Counts& counts);

  /**
   * Everything but colours that transfer functions give.
   */
  static void BuildFields(
    const vtkTetrahedraArrays& arrays, const vtkTetrahedraMesh& mesh, vtkTetrahedraFields& fields);

  /**
   * Kind, scalars, and colours where they are not looked up while drawing. Extinction is opacity
   * times \a unit.
   */
  static std::string BuildColors(const vtkTetrahedraArrays& arrays, const vtkTetrahedraMesh& mesh,
    vtkVolumeProperty* property, double unit, vtkTetrahedraFields& fields);

  /**
   * The component that colours, or -1 for the magnitude of a vector.
   */
  static int GetColoringComponent(vtkDataArray* scalars, vtkVolumeProperty* property);
};

#endif
