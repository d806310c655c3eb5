// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBoundary_h
#define ReferenceBoundary_h

#include <array>  // for points
#include <vector> // for faces

class vtkDataSet;

namespace reference
{

/**
 * @class   DomainBoundary
 * @brief   the faces of a mesh that belong to one cell only
 *
 * Faces are planar and convex. Points are taken to lie in a face within 1e-10 of the mesh's size.
 */
class DomainBoundary
{
public:
  using Point = std::array<double, 3>;

  explicit DomainBoundary(vtkDataSet* mesh);

  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  /// The first face that holds all \a points, or -1.
  int Find(const std::vector<Point>& points) const;
  /// The area of a face.
  double GetArea(int face) const { return this->Faces[face].Area; }
  /// The area of a triangle in a face, negative when it is turned to the inside of the mesh.
  double SignedArea(int face, const std::vector<Point>& triangle) const;

private:
  struct Face
  {
    std::vector<Point> Corners;
    Point Normal; ///< of length 1, outward
    double Area;
  };

  bool Holds(const Face& face, const Point& point) const;

  std::vector<Face> Faces;
  double Tolerance;
};

}

#endif
