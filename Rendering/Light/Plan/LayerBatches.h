// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LayerBatches_h
#define interlume_LayerBatches_h

#include "Plan/SlicePlan.h"

#include <cstddef>
#include <vector>

namespace interlume
{

class SlicePolygons;

/**
 * @class   LayerBatches
 * @brief   the slabs whose matter goes into an area light's layers together, and where it is
 *
 * A batch begins at a slab with matter. It ends where the shadows of the emitter's edge and of its
 * center have diverged by two texels of the light's buffer, or by a twentieth of their divergence
 * over the whole volume. All matter of a batch is treated as if it were in the batch's middle
 * plane, which shifts shadows by up to half that divergence. With the first bound alone, this would
 * be a large part of the width of a small light's penumbras. The second costs at most twenty
 * batches. Its tiles are the squares of about TileSize texels of the light's buffer that a slice of
 * the batch, with a border for interpolation, lies in; neighbors in a row are one rectangle.
 * Nothing but them meets matter or has matter that asks for light. The last batch has the whole
 * buffer, so that it is known everywhere in the end.
 */
class LayerBatches
{
public:
  static constexpr int TileSize = 16;

  struct Batch
  {
    /// The first and last slab with something in it.
    int First = 0;
    int Last = 0;
  };

  /// Finds the batches of the matter of all \a polygons. All of them have the whole buffer where
  /// \a isWhole.
  void Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const std::vector<const SlicePolygons*>& polygons, bool isWhole);

  /// Returns whether shadows go apart by more than in a number of batches between the end of one
  /// batch and the start of another.
  bool AreApart(const Batch& first, const Batch& second, int batches) const;

  const std::vector<Batch>& Get() const { return this->Batches; }
  /// Returns the corners x, y, 0 of triangles in clip coordinates of the buffer, batch after batch.
  const std::vector<float>& GetVertices() const { return this->Vertices; }
  /// Returns the first vertex of each batch, and their number.
  const std::vector<std::size_t>& GetStarts() const { return this->Starts; }

private:
  /// Finds the numbers below from which batches end.
  void Spread(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  /// Returns whether so many batches cannot hold all slabs from \a first up to \a end.
  bool AreMore(int first, int end, int batches) const;

  std::vector<Batch> Batches;
  /// The most slabs of a batch.
  int Period = 1;
  /// How far shadows go apart up to each slab and up to the end of the sweep, in texels, and the
  /// most within a batch.
  std::vector<double> Apart;
  double MostApart = 0.0;
  std::vector<float> Vertices;
  std::vector<std::size_t> Starts = { 0 };
};

}

#endif
