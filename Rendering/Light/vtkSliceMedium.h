// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSliceMedium_h
#define vtkSliceMedium_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for the source

class vtkShaderProgram;

/**
 * @class   vtkSliceMedium
 * @brief   a medium defined by GLSL functions instead of a volume's scalars
 *
 * A mapper for such a medium owns a vtkShadowedSliceMapper and passes the medium to SetMedium. The
 * scalars and transfer functions of that vtkShadowedSliceMapper then only determine which blocks of
 * 16^3 cells are not empty. The scalars are not uploaded.
 *
 * The GLSL source defines the following functions. It may also declare uniforms and textures whose
 * names do not occur in the slice shaders.
 * - `float mediumAt(vec3 p, mat3 size, out vec3 color)` returns the extinction per unit length in
 *   world coordinates, and the color, at the position \a p. Positions are texture coordinates of
 *   the volume: 0 to 1, with the first and last samples half a voxel inside. The columns of \a size
 *   are the extents of the sample in the same coordinates: a segment of the ray, and the two edges
 *   of a pixel of the frame or the light buffer. They are 0 if unknown.
 * - `vec3 axisAt(vec3 p)`, if HasReflection: returns the unit vector that defines the reflection at
 *   \a p, such as a surface normal or the direction of a line, or 0 if there is none.
 * - `vec2 reflectionOf(vec3 axis, vec3 l, vec3 eye)`, if HasReflection: returns the diffuse and
 *   specular factors of the reflected light. The specular power is already applied. The unit
 *   vectors \a l and \a eye point toward the light and the camera, in world coordinates.
 *
 * @sa vtkShadowedSliceMapper
 */
class INTERLUMELIGHT_EXPORT vtkSliceMedium : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkSliceMedium, vtkObject);

  /// Returns the GLSL source of the functions.
  virtual std::string GetSource() = 0;
  /// Returns true if axisAt and reflectionOf define the reflection when the property's Shade is on.
  /// Otherwise the medium scatters light isotropically.
  virtual bool HasReflection() = 0;

  ///@{
  /// Activate binds the textures that the program samples and sets its uniforms. Deactivate unbinds
  /// the textures.
  virtual void Activate(vtkShaderProgram* program) = 0;
  virtual void Deactivate() = 0;
  ///@}

  /// Receives the errors and warnings of a frame, once for each state of the mapper.
  virtual void ReportError(const std::string& text) = 0;

protected:
  vtkSliceMedium();
  ~vtkSliceMedium() override;

private:
  vtkSliceMedium(const vtkSliceMedium&) = delete;
  void operator=(const vtkSliceMedium&) = delete;
};

#endif
