// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSliceMatter_h
#define vtkSliceMatter_h

#include "InterlumeLightModule.h" // for the export macro

#include <string> // for sources

class vtkShaderProgram;

/**
 * @class   vtkSliceMatter
 * @brief   matter that slices look up by functions of its own, not in a volume's scalars
 *
 * A mapper of such matter gives it to a vtkShadowedSliceMapper of its own by SetMatter. The scalars
 * of that mapper then tell by its functions where there is matter at all, in blocks of 16^3 cells,
 * and nothing of them is sent to the graphics card.
 *
 * **Functions** in the source, with any uniforms and textures of names that no slice has:
 * - `float matterAt(vec3 p, mat3 size, out vec3 color)` returns the extinction in a unit of length
 *   of the world at a place of the volume's texture, 0 to 1, samples half a voxel inside, and its
 *   colour. The columns of `size` are what the sample stands for in the same coordinates: a piece
 *   of the ray and the two edges of a pixel of the picture, or of a light's buffer, there; 0 where
 *   nothing is known.
 * - `vec3 axisAt(vec3 p)`, where HasReflection: the axis that light is reflected by, 0 for none.
 * - `vec2 reflectionOf(vec3 axis, vec3 l, vec3 eye)`, where HasReflection: the diffuse and the
 *   specular share of light, the power included. l is a direction towards the light and eye one
 *   towards the eye, both of length 1, in the world's axes.
 *
 * @sa vtkShadowedSliceMapper
 */
class INTERLUMELIGHT_EXPORT vtkSliceMatter
{
public:
  vtkSliceMatter() = default;
  virtual ~vtkSliceMatter();
  vtkSliceMatter(const vtkSliceMatter&) = delete;
  void operator=(const vtkSliceMatter&) = delete;

  /// Returns the functions.
  virtual std::string GetSource() const = 0;
  /// Returns whether light is reflected by axes of the matter, where the property's Shade is on;
  /// else it is scattered evenly.
  virtual bool HasReflection() const = 0;

  ///@{
  /// Binds the textures that a program reads and sets its uniforms, and unbinds all textures.
  virtual void Activate(vtkShaderProgram* program) = 0;
  virtual void Deactivate() = 0;
  ///@}

  /// Reports the errors and warnings of an image, once for one state of the mapper.
  virtual void ReportFault(const std::string& text) = 0;
};

#endif
