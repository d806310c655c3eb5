// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TileRasterizer_h
#define interlume_TileRasterizer_h

#include "Frame/TetrahedraFrame.h"
#include "Software/FragmentClones.h"
#include "Software/FragmentIntegration.h"
#include "Software/Fragments.h"
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
 * @brief   draws one tile at a time, for one thread
 */
class TileRasterizer
{
public:
  static constexpr int SIZE = TileBins::SIZE;
  /// A pixel as RGB times opacity and opacity, or as the sums that the blend mode keeps.
  using Pixel = std::array<float, 4>;

  TileRasterizer(const TetrahedraFrame& frame, const TileBins& bins);

  void Draw(int tile);

  int GetLeft() const { return this->Left; }
  int GetBottom() const { return this->Bottom; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  /// Returns the colour multiplied by opacity, after Draw().
  const Pixel& GetPixel(int x, int y) const { return this->Pixels[y * SIZE + x]; }
  /// Return the tetrahedron plus 1, and its depth, for SELECTION.
  std::uint32_t GetTetrahedron(int x, int y) const { return this->Nearest[y * SIZE + x]; }
  float GetDepth(int x, int y) const { return this->NearestDepth[y * SIZE + x]; }

private:
  using Projected = TetrahedraView::Projected;

  void Begin(int tile);
  /// Draws the tetrahedra of a tile. Colors is the number of channels of point colours, 4 or 0;
  /// Scalars and DeltaT tell whether there are any.
  template <bool Scalars, bool Colors, bool DeltaT>
  void DrawTetrahedra(int tile);
  template <bool Scalars, bool Colors, bool DeltaT>
  void DrawTetrahedron(std::uint32_t tetrahedron);
  /// DrawTetrahedra for each kind of fields, as functions that can be compiled for more than one
  /// processor.
  INTERLUME_CLONES void DrawScalars(int tile);
  INTERLUME_CLONES void DrawScalarsInTime(int tile);
  INTERLUME_CLONES void DrawColors(int tile);
  INTERLUME_CLONES void DrawColorsInTime(int tile);
  INTERLUME_CLONES void DrawCells(int tile);
  INTERLUME_CLONES void DrawCellsInTime(int tile);
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
  float LengthScale = 1.0f;

  int Left = 0;
  int Bottom = 0;
  int Width = 0;
  int Height = 0;
  std::vector<Pixel> Pixels;
  /// The layer being drawn (PRIORITY), summed up.
  std::vector<Pixel> Layer;
  /// The fragments of the boundary; null where none is drawn.
  std::unique_ptr<SurfaceFragments> Surface;
  std::vector<float> Slant;
  std::vector<float> Opaque;
  std::vector<std::uint32_t> Nearest;
  std::vector<float> NearestDepth;
};

}

#endif
