#ifndef vtkSurfaceFragments_h
#define vtkSurfaceFragments_h

#include "vtkFragments.h"
#include "vtkTetrahedraPicture.h"
#include "vtkTetrahedronSilhouette.h"
#include "vtkTileBins.h"

#include <array>
#include <vector>

/**
 * @class   vtkSurfaceFragments
 * @brief   boundary triangles where segments pass them
 *
 * A segment enters its tetrahedron through one face and leaves it through another. Where that face
 * is a boundary triangle, its shaded colour is laid before or behind the segment.
 */
class vtkSurfaceFragments
{
public:
  explicit vtkSurfaceFragments(const vtkTetrahedraPicture& picture, const vtkTileBins& bins)
    : Picture(picture)
    , Bins(bins)
  {
  }

  /**
   * Colours, times opacity, at both ends of all segments; opacity 0 where there is no triangle.
   * \a left and \a bottom are the tile's; \a opaque is the depth of each of its pixels, or null.
   */
  void Compute(const vtkFragments& fragments, int left, int bottom, const float* opaque);

  const vtkFragments::Color& GetFront(int i) const { return this->Colors[0][i]; }
  const vtkFragments::Color& GetBack(int i) const { return this->Colors[1][i]; }

private:
  using Value = vtkTetrahedronSilhouette::Value;
  /// Depth, three of the normal, two texture coordinates.
  static constexpr int CHANNELS = 6;

  void SetTetrahedron(std::uint32_t tetrahedron);
  /// The edge next to which a pixel lies; returns lambda there.
  double Locate(double x, double y, int& edge) const;

  const vtkTetrahedraPicture& Picture;
  const vtkTileBins& Bins;
  std::uint32_t Tetrahedron = 0xffffffffu;
  vtkTetrahedronSilhouette Shape;
  std::array<Value, CHANNELS> Values;
  std::array<vtkFragments::Color, vtkFragments::CAPACITY> Colors[2];
};

#endif
