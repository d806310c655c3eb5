// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneFields_h
#define interlume_SceneFields_h

#include "Receivers/ScatteredField.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace interlume
{

/**
 * @class   SceneFields
 * @brief   what surfaces receive of light that volumes scatter, for shaders of VTK's mappers
 *
 * To the diffuse light of a surface of normal n is added, times its diffuse colour, the irradiance
 * of the half space before it by the first two moments of the light that a volume has scattered,
 *   E = integral over directions w, dot(w, n) < 0, of phi / (4 pi) (1 + 3 dot(f, w)) (-dot(w, n))
 *     = phi (1/4 - dot(f, n) / 2),
 * phi the fluence and f the lean of ScatteringField, in the units in which a light of colour 1 that
 * shines along -n gives 1; and F max(-dot(n, l), 0) of the light F that goes on along the direction
 * l of each light. Both are looked up, between the cells' middles, where no cell that the surface
 * itself blocks has a part: 1.5 (|n.x| + |n.y| + |n.z|) cells before it, n in the axes of the
 * cells, if there are blocked cells.
 *
 * Beyond the volume's box this is an estimate: phi, f and F are those of the nearest place u of the
 * box, a distance d away; from one cell on n in dot(f, n) is the direction to it, and E is taken
 * times s mix(max(c, 0), (1 + c) / 2, s), c the cosine between n and that direction and s =
 * R^2 / (R^2 + d^2) the form factor of a disc as large as the box's largest side, seen from its
 * axis. Where something is between the two is not asked. A quarter of an edge below a white cube of
 * optical depth 3 in light from above it is 1.39 times the light that comes from there for an
 * isotropic phase function, and 0.99 times for one of g = 0.75.
 */
class SceneFields
{
public:
  /// Takes the fields of a frame, whose textures stay until the next one.
  void Set(const std::vector<ScatteredField>& fields) { this->Fields = fields; }
  /// Forgets the textures, so that no light comes, and keeps the source.
  void Forget();
  bool IsEmpty() const { return this->Fields.empty(); }
  const std::vector<ScatteredField>& Get() const { return this->Fields; }

  /// Returns what a shader has to declare: `sceneScattered(place, normal)` in view coordinates.
  /// Empty without fields.
  std::string GetSource() const;
  /// Sets the uniforms; no light comes where not \a isLit, else the textures are active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromView, bool isLit) const;

private:
  std::vector<ScatteredField> Fields;
};

}

#endif
