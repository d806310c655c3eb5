// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraReport_h
#define interlume_TetrahedraReport_h

#include "vtkType.h"

#include <string>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   TetrahedraReport
 * @brief   values that vtkTimeWeightedTetrahedraMapper reports of its last image
 *
 * Counts of a step that was not taken are 0. Strings are empty before the first image.
 */
struct TetrahedraReport
{
  /// vtkTimeWeightedTetrahedraMapper::RenderPaths, BlendModes and SortModes, each resolved from its
  /// automatic choice, and the shader of silhouettes with the OpenGL path, one of
  /// SilhouetteShaders; 0 with the other path.
  int RenderPath = 0;
  int BlendMode = 0;
  int SortMode = 0;
  int SilhouetteShader = 0;
  /// The reason for each of them.
  std::string PathReason;
  std::string BlendReason;
  std::string SortReason;
  std::string ShaderReason;
  /// The names of the parts of the shader or kernel that ran, separated by spaces, such as `scalars
  /// perspective composite`; `delta-t` and `surface` are among them only if they are used.
  std::string Features;

  /// The numbers of tetrahedra of the input, of those drawn (in view, level of detail applied), and
  /// of those cut by the near plane or a clipping plane.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraDrawn = 0;
  vtkIdType TetrahedraClipped = 0;
  /// The numbers of tetrahedra skipped because they have no volume, and because of NaN or infinity
  /// in a coordinate or array at a corner.
  vtkIdType FlatTetrahedra = 0;
  vtkIdType NonFiniteTetrahedra = 0;
  /// The numbers of boundary triangles drawn, and of input triangles that are no face of a
  /// tetrahedron.
  vtkIdType BoundaryTriangles = 0;
  vtkIdType UnmatchedTriangles = 0;

  /// The number of processes whose pieces were combined in this image; 0 if this process drew only
  /// its own piece, also if images are composited afterwards.
  int Processes = 0;

  /// The numbers of passes over the tetrahedra (priority: one for each layer), and of layers.
  int Passes = 0;
  int Layers = 0;
  /// The numbers of tetrahedra in cycles of visibility, and of gaps where a line of sight leaves
  /// the mesh and enters it again (relations added across gaps), both for MPVONC.
  vtkIdType Cycles = 0;
  vtkIdType Gaps = 0;
  /// Whether tetrahedra were sorted for this image, and whether face adjacency is cached.
  bool Sorted = false;
  bool HasAdjacency = false;

  /// The bytes uploaded to the graphics card for this image: static data, order, textures of the
  /// image.
  vtkIdType UploadedStaticBytes = 0;
  vtkIdType UploadedOrderBytes = 0;
  vtkIdType UploadedImageBytes = 0;
  /// The number of off-screen buffers, and the bytes in buffers of the graphics card and in main
  /// memory.
  int Buffers = 0;
  vtkIdType BufferBytes = 0;
  vtkIdType MemoryBytes = 0;

  /// The level of detail: the number of pixels of the image per computed pixel (1, 2, 4, ... along
  /// an edge), and the number of tetrahedra per drawn one. Both are 1 for a full image.
  int PixelStride = 1;
  int TetrahedronStride = 1;
  /// The number of control points of the transfer functions, after reduction to straight pieces.
  int ControlPoints = 0;
  /// Seconds of this image, until the graphics card was done if AutoAdjustLevelOfDetail is on.
  double Seconds = 0.0;

  /// Whether values of the input were read again for this image, and whether the mesh was rebuilt.
  /// If points and tetrahedra are those of the last image, as in a new time step of the same mesh,
  /// the mesh, its adjacency, boundary, order and what was uploaded of them are reused.
  bool ValuesUpdated = false;
  bool MeshRebuilt = false;

  /// Replaces all values of a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
