// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PropSurfaces_h
#define interlume_PropSurfaces_h

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

class vtkProp;

namespace interlume
{

/**
 * @class   PropSurfaces
 * @brief   triangles of opaque props in world coordinates
 *
 * Triangles come from the polygons and strips of actors that are drawn as surfaces. Their mappers
 * must draw vtkPolyData or composite data of vtkPolyData. Actors in assemblies are included. A
 * vtkGlyph3DMapper contributes a copy of its source for each glyph (GlyphInstances). vtkLODProp3D
 * and mappers that generate polygons on the GPU are not supported.
 */
class PropSurfaces
{
public:
  struct Surface
  {
    /// Three points per triangle.
    std::vector<glm::dvec3> Corners;
    /// Clipping planes of the mapper. The dot product with (x, y, z, 1) is positive on the visible
    /// side.
    std::vector<glm::dvec4> Planes;
  };

  /// Returns one surface for each actor that has triangles.
  static std::vector<Surface> Get(const std::vector<vtkProp*>& props);
};

}

#endif
