// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GlyphInstances_h
#define interlume_GlyphInstances_h

#include <vector>

#include <glm/mat4x4.hpp>

class vtkDataSet;
class vtkGlyph3DMapper;

namespace interlume
{

/**
 * @class   GlyphInstances
 * @brief   sources and transforms of the glyphs of a vtkGlyph3DMapper
 *
 * The glyphs are the same as in vtkOpenGLGlyph3DMapper. They depend on the mapper's Scaling,
 * ScaleMode, ScaleFactor, Clamping, Range, Orient, OrientationMode, SourceIndexing and Masking, and
 * on the point arrays that the mapper selects for them. A point has no glyph if it is masked or if
 * the orientation array has the wrong number of components.
 */
class GlyphInstances
{
public:
  struct Instance
  {
    /// Index of the source.
    int Source;
    /// Transform from source coordinates to the coordinates of the points.
    glm::dmat4 Matrix;
  };

  /// Returns one entry for each point of the dataset that has a glyph.
  static std::vector<Instance> Get(vtkGlyph3DMapper* mapper, vtkDataSet* points);
};

}

#endif
