// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraBuilder_h
#define interlume_TetrahedraBuilder_h

#include "Common/Error.h"
#include "Mesh/TetrahedraArrays.h"
#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"

class vtkDataArray;
class vtkVolumeProperty;

namespace interlume
{

/**
 * @class   TetrahedraBuilder
 * @brief   builds TetrahedraFields from the arrays of a grid
 */
class TetrahedraBuilder
{
public:
  /**
   * Builds the extents in time and the layers.
   */
  static void BuildDeltaTAndLayers(
    const TetrahedraArrays& arrays, const TetrahedraMesh& mesh, TetrahedraFields& fields);

  /**
   * Sets the kind of the fields, and then either the scalars (kind SCALARS; their colors are looked
   * up during drawing) or the colors (other kinds). Extinction is opacity times \a unit. Returns an
   * error if the scalars have too many components.
   */
  static Error BuildColors(const TetrahedraArrays& arrays, const TetrahedraMesh& mesh,
    vtkVolumeProperty* property, double unit, TetrahedraFields& fields);

  /**
   * Returns the component used for coloring, or -1 for the magnitude of a vector.
   */
  static int GetColoringComponent(vtkDataArray* scalars, vtkVolumeProperty* property);
};

}

#endif
