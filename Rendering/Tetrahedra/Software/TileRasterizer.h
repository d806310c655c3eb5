// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TileRasterizer_h
#define interlume_TileRasterizer_h

#include "Frame/TetrahedraFrame.h"
#include "Software/FragmentIntegration.h"
#include "Software/Fragments.h"
#include "Software/SeenTetrahedra.h"
#include "Software/SurfaceFragments.h"
#include "Software/TileBins.h"
#include "View/TetrahedronSilhouette.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   TileRasterizer
 * @brief   draws one tile at a time, in one thread
 */
class TileRasterizer
{
public:
  static constexpr int SIZE = TileBins::SIZE;
  /// RGB premultiplied by opacity, and opacity; or the sums or maxima of the blend mode.
  using Pixel = std::array<float, 4>;

  TileRasterizer(const TetrahedraFrame& frame, const TileBins& bins);

  void Draw(int tile);

  int GetLeft() const { return this->Left; }
  int GetBottom() const { return this->Bottom; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  /// Returns a pixel of the tile. Call it after Draw().
  const Pixel& GetPixel(int x, int y) const { return this->Pixels[y * SIZE + x]; }
  /// Returns the tetrahedron seen at a pixel. Call it after Draw() with IsSelection.
  const SeenTetrahedra::Seen& GetSeen(int x, int y) const { return this->Seen->Get(y * SIZE + x); }

private:
  using Projected = TetrahedraView::Projected;

  void Begin(int tile);
  /// Draw the tetrahedra of a tile. Each template parameter is true if the fields contain this kind
  /// of value.
  template <bool Scalars, bool Colors, bool DeltaT>
  void DrawTetrahedra(int tile);
  template <bool Scalars, bool Colors, bool DeltaT>
  void DrawTetrahedron(std::uint32_t tetrahedron);
  void FetchAhead(const std::uint32_t* tetrahedron, const std::uint32_t* end) const;
  void Flush();
  void IntegrateAndBlend();
  bool IsOpaque() const;
  void ResolveLayer();
  void Finish();

  const TetrahedraFrame& Frame;
  const TileBins& Bins;
  FragmentIntegration::Channels Channels;
  interlume::Fragments Fragments;

  int Left = 0;
  int Bottom = 0;
  int Width = 0;
  int Height = 0;
  std::vector<Pixel> Pixels;
  /// Sums of the current layer (PRIORITY).
  std::vector<Pixel> Layer;
  /// Boundary triangles; null if none are drawn.
  std::unique_ptr<SurfaceFragments> Surface;
  std::vector<float> Slant;
  std::vector<float> Opaque;
  /// Tetrahedra seen; null except with IsSelection.
  std::unique_ptr<SeenTetrahedra> Seen;
};

}

#endif
