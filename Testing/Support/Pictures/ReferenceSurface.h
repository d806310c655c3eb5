// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSurface_h
#define ReferenceSurface_h

#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/TriangleTree.h"

#include <functional>
#include <vector>

class vtkPolyData;

namespace reference
{

/**
 * @class   ReferenceSurface
 * @brief   the triangles of an actor in the world, and how they reflect, in double
 *
 * Polygons and strips are cut into triangles; points and lines are left out. Normals are the mesh's
 * point normals, interpolated, where it has them and the property is not flat, else those of the
 * triangles; they are turned to the eye with the side of the triangle that it sees. Clipping
 * planes of the mapper cut the surface.
 *
 * The light that is reflected is that of VTK's own shader: ambient, diffuse and Phong's specular
 * term of the property, without ambient terms of lights.
 */
class ReferenceSurface
{
public:
  using Hit = TriangleTree::Meeting;

  /// std::invalid_argument for a texture, colours by scalars and physically based shading, which
  /// the reference does not know.
  explicit ReferenceSurface(const SceneSurface& surface);

  /// 0 to 1.
  double GetOpacity() const { return this->Opacity; }

  /// Appends what the ray meets at distances in (begin, end), the nearest first.
  void AppendHits(const Double3& origin, const Double3& direction, double begin, double end,
    std::vector<Hit>& hits) const;
  /// The share of light that comes through at distances in (begin, end).
  double GetTransmittance(
    const Double3& origin, const Double3& direction, double begin, double end) const;

  /// What a place of the surface reflects along -direction, of length 1.
  Double3 Shade(const Hit& hit, const Double3& world, const Double3& direction,
    const std::vector<ReferenceLightSource::Arrival>& arrivals) const;

  /// The length of the diagonal of the surface's bounding box.
  double GetSize() const { return this->Size; }

private:
  void Append(vtkPolyData* mesh, vtkMatrix4x4* worldFromMesh, bool withNormals);
  bool IsClipped(const Double3& world) const;
  /// Turned to the eye.
  Double3 GetNormal(const Hit& hit, const Double3& direction) const;

  TriangleTree Tree;
  /// Three for each triangle; empty where they are the triangles' own.
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
