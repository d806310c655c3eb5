// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSurface_h
#define ReferenceSurface_h

#include "Support/Images/MixedScene.h"
#include "Support/Images/TriangleTree.h"

#include <functional>
#include <vector>

class vtkPolyData;

namespace reference
{

/**
 * @class   ReferenceSurface
 * @brief   the triangles of an actor in world coordinates, and the light they reflect, in double
 * precision
 *
 * Polygons and strips are triangulated; vertices and lines are ignored. Normals are the
 * interpolated point normals of the mesh, or the normals of the triangles if the mesh has no point
 * normals or shading is flat. They are flipped where the back of a triangle faces the camera.
 * Clipping planes of the mapper are applied.
 *
 * Reflection follows VTK's shader, with the ambient, diffuse and Phong specular terms of the
 * property. Ambient colors of lights are ignored.
 */
class ReferenceSurface
{
public:
  using Hit = TriangleTree::Hit;

  /// Throws std::invalid_argument for textures, scalar coloring and physically based shading, which
  /// are not supported.
  explicit ReferenceSurface(const SceneSurface& surface);

  /// Returns the opacity, 0 to 1.
  double GetOpacity() const { return this->Opacity; }

  /// Appends the hits of a ray at distances in (begin, end), sorted by distance.
  void AppendHits(const Double3& origin, const Double3& direction, double begin, double end,
    std::vector<Hit>& hits) const;
  /// Returns the transmittance of the part of a ray at distances in (begin, end).
  double GetTransmittance(
    const Double3& origin, const Double3& direction, double begin, double end) const;

  /// Returns the light that is reflected at a hit toward -direction, a unit vector.
  Double3 Shade(const Hit& hit, const Double3& world, const Double3& direction,
    const std::vector<ReferenceLightSource::Arrival>& arrivals) const;

  /// Returns the length of the diagonal of the bounding box.
  double GetSize() const { return this->Size; }

private:
  void Append(vtkPolyData* mesh, vtkMatrix4x4* worldFromMesh, bool withNormals);
  bool IsClipped(const Double3& world) const;
  /// Returns the unit normal that points to the side from which the ray comes.
  Double3 GetNormal(const Hit& hit, const Double3& direction) const;

  TriangleTree Tree;
  /// Three point normals per triangle. If empty, the normals of the triangles are used.
  std::vector<glm::dvec3> Normals;
  bool IsMirrored = false;
  std::function<Double3(const Double3&)> Color;
  Double3 Ambient{};
  Double3 Diffuse{};
  Double3 Specular{};
  double SpecularPower = 1.0;
  double Opacity = 1.0;
  double Size = 0.0;
  std::vector<vtkSmartPointer<vtkPlane>> Planes;
};

}

#endif
