// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneScatteredLight_h
#define interlume_SceneScatteredLight_h

#include "Receivers/ScatteredLightTexture.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace interlume
{

/**
 * @class   SceneScatteredLight
 * @brief   irradiance of surfaces from light scattered by volumes, for shaders of VTK's mappers
 *
 * The shaders add the following irradiance, times the diffuse color, to the diffuse light of a
 * surface with normal n. The first part is the irradiance of the half space in front of the
 * surface, from the first two moments of the scattered light:
 *   E = integral over directions w, dot(w, n) < 0, of phi / (4 pi) (1 + 3 dot(f, w)) (-dot(w, n))
 *     = phi (1/4 - dot(f, n) / 2),
 * where phi is Fluence and f is NetFlux of ScatteredLight. A light of color 1 that shines along -n
 * has an irradiance of 1 in these units. The second part is F max(-dot(n, l), 0) for each light,
 * where F is the forward-scattered light of the light and l is its direction.
 *
 * If there are blocked cells, both parts are sampled in front of the surface, at a distance of 1.5
 * (|n.x| + |n.y| + |n.z|) cells, with the components of n along the axes of the cells. There, cells
 * that the surface itself blocks do not contribute to the samples.
 *
 * Outside the volume's box, this is an estimate. phi, f and F are sampled at the point u of the box
 * that is nearest to the surface. If its distance d is at least one cell, n in dot(f, n) is
 * replaced with the direction to u, and both parts are multiplied by
 * s mix(max(c, 0), (1 + c) / 2, s). Here c is the cosine between n and the direction to u, and
 * s = R^2 / (R^2 + d^2) is the form factor of a disk with the area of the box's largest face and
 * radius R, seen from a point on its axis. Occlusion between the surface and u is ignored. The
 * estimate may exceed the light from the volume, in particular for isotropic scattering.
 */
class SceneScatteredLight
{
public:
  /// Sets the scattered light for a frame. The textures must remain valid until the next frame.
  void Set(const std::vector<ScatteredLightTexture>& fields) { this->Fields = fields; }
  /// Clears the textures, so that there is no scattered light. GetSource does not change.
  void ClearTextures();
  bool IsEmpty() const { return this->Fields.empty(); }
  const std::vector<ScatteredLightTexture>& Get() const { return this->Fields; }

  /// Returns the code of the GLSL function `sceneScattered(place, normal)`, whose parameters are in
  /// view coordinates. Returns an empty string if there is no scattered light.
  std::string GetSource() const;
  /// Sets the uniforms. If \a isLit is false, there is no scattered light. Otherwise the textures
  /// must be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromView, bool isLit) const;

private:
  std::vector<ScatteredLightTexture> Fields;
};

}

#endif
