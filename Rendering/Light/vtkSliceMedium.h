// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSliceMedium_h
#define vtkSliceMedium_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for sources

class vtkShaderProgram;

/**
 * @class   vtkSliceMedium
 * @brief   a medium that slices evaluate by GLSL functions instead of a volume's scalars
 *
 * A mapper of such a medium has a vtkShadowedSliceMapper of its own and calls its SetMedium. The
 * scalars of that mapper then only determine, by its transfer functions, which blocks of 16^3 cells
 * are not empty, and are not uploaded.
 *
 * **Functions** in the source, with any uniforms and textures whose names no slice has:
 * - `float mediumAt(vec3 p, mat3 size, out vec3 color)` returns the extinction per unit of length
 *   in world coordinates, and the color, at a position in the volume's texture coordinates, 0 to 1
 *   with samples half a voxel inside. The columns of `size` are the extent of the sample in the
 *   same coordinates: a piece of the ray and the two edges of a pixel of the image or the light
 *   buffer; 0 if unknown.
 * - `vec3 axisAt(vec3 p)`, if HasReflection: the axis that light is reflected by, 0 for none.
 * - `vec2 reflectionOf(vec3 axis, vec3 l, vec3 eye)`, if HasReflection: the diffuse and specular
 *   share of light, the power included. l is the unit vector toward the light and eye the one
 *   toward the camera, both in world coordinates.
 *
 * @sa vtkShadowedSliceMapper
 */
class INTERLUMELIGHT_EXPORT vtkSliceMedium : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkSliceMedium, vtkObject);

  /// Returns the functions.
  virtual std::string GetSource() = 0;
  /// Returns whether light is reflected by axes of the medium if the property's Shade is on;
  /// otherwise it is scattered evenly.
  virtual bool HasReflection() = 0;

  ///@{
  /// Binds the textures that a program reads and sets its uniforms; unbinds the textures.
  virtual void Activate(vtkShaderProgram* program) = 0;
  virtual void Deactivate() = 0;
  ///@}

  /// Receives the errors and warnings of an image, once for one state of the mapper.
  virtual void ReportError(const std::string& text) = 0;

protected:
  vtkSliceMedium();
  ~vtkSliceMedium() override;

private:
  vtkSliceMedium(const vtkSliceMedium&) = delete;
  void operator=(const vtkSliceMedium&) = delete;
};

#endif
