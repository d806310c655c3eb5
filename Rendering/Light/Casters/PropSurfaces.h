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
 * @brief   the triangles of opaque props in world coordinates
 *
 * They are those of polygons and strips of actors whose mappers draw vtkPolyData, each by itself or
 * in composite data, as surfaces; those of assemblies too, and of vtkGlyph3DMapper, a copy of its
 * sources at each place (GlyphPlaces). vtkLODProp3D and mappers that make their polygons on the
 * graphics card have none here.
 */
class PropSurfaces
{
public:
  struct Surface
  {
    /// Three to a triangle.
    std::vector<glm::dvec3> Corners;
    /// The mapper's clipping planes: x, y, z, 1 times each is positive where it leaves something.
    std::vector<glm::dvec4> Planes;
  };

  /// Returns a surface for each actor that has triangles.
  static std::vector<Surface> Get(const std::vector<vtkProp*>& props);
};

}

#endif
