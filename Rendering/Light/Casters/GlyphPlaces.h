// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GlyphPlaces_h
#define interlume_GlyphPlaces_h

#include <vector>

#include <glm/mat4x4.hpp>

class vtkDataSet;
class vtkGlyph3DMapper;

namespace interlume
{

/**
 * @class   GlyphPlaces
 * @brief   where a vtkGlyph3DMapper draws which of its sources
 *
 * Places are those of vtkOpenGLGlyph3DMapper: by its Scaling, ScaleMode, ScaleFactor, Clamping,
 * Range, Orient, OrientationMode, SourceIndexing and Masking, and by the arrays of points that it
 * is told to take for them. Points with another number of components than an array needs have no
 * glyph.
 */
class GlyphPlaces
{
public:
  struct Place
  {
    /// The number of the source.
    int Source;
    /// From coordinates of the source to those of the points.
    glm::dmat4 Matrix;
  };

  /// Returns a place for each point of the dataset that has a glyph.
  static std::vector<Place> Get(vtkGlyph3DMapper* mapper, vtkDataSet* points);
};

}

#endif
