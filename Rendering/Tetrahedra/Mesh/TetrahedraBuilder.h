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
 * @brief   makes the fields that are drawn from the arrays of a grid
 */
class TetrahedraBuilder
{
public:
  /**
   * Makes all fields but colours that transfer functions give.
   */
  static void BuildFields(
    const TetrahedraArrays& arrays, const TetrahedraMesh& mesh, TetrahedraFields& fields);

  /**
   * Sets the kind, the scalars, and the colors that are not looked up while drawing. Extinction is
   * opacity times \a unit. Returns an error if there are too many components.
   */
  static Error BuildColors(const TetrahedraArrays& arrays, const TetrahedraMesh& mesh,
    vtkVolumeProperty* property, double unit, TetrahedraFields& fields);

  /**
   * Returns the component that colours, or -1 for the magnitude of a vector.
   */
  static int GetColoringComponent(vtkDataArray* scalars, vtkVolumeProperty* property);
};

}

#endif
