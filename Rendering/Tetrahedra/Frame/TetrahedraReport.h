// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTetrahedraReport_h
#define vtkTetrahedraReport_h

#include "InterlumeTetrahedraModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <string> // for the reasons

/**
 * @class   vtkTetrahedraReport
 * @brief   what vtkTimeWeightedTetrahedraMapper did in its last picture
 *
 * This is a plain value object. Counts that belong to a step that was not taken are 0, and the
 * strings are empty before the first picture.
 *
 * @sa vtkTimeWeightedTetrahedraMapper
 */
struct INTERLUMETETRAHEDRA_EXPORT vtkTetrahedraReport
{
  /// What was used: vtkTimeWeightedTetrahedraMapper::RenderPaths, BlendModes, SortModes, each
  /// resolved from its automatic choice, and the shader that made silhouettes with the OpenGL path,
  /// of SilhouetteShaders; 0 with the other.
  int RenderPath = 0;
  int BlendMode = 0;
  int SortMode = 0;
  int SilhouetteShader = 0;
  /// Why each of them.
  std::string PathReason;
  std::string BlendReason;
  std::string SortReason;
  std::string ShaderReason;
  /// The names of the parts of shader or kernel that ran, separated by spaces, such as `scalars
  /// perspective composite`; `delta-t` and `surface` are among them only when they are used.
  std::string Features;

  /// The numbers of tetrahedra of the input, of those drawn (in view, level of detail applied), and
  /// of those cut by the near plane or a clipping plane.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraDrawn = 0;
  vtkIdType TetrahedraClipped = 0;
  /// The numbers of tetrahedra left out because they have no volume, and because of NaN or infinity
  /// in a coordinate or array at a corner.
  vtkIdType FlatTetrahedra = 0;
  vtkIdType NonFiniteTetrahedra = 0;
  /// The numbers of boundary triangles drawn, and of those of the input that are no face of a
  /// tetrahedron.
  vtkIdType BoundaryTriangles = 0;
  vtkIdType UnmatchedTriangles = 0;

  /// The number of processes whose pieces were put together in this picture; 0 where this one drew
  /// alone, and where pictures are laid over each other.
  int Processes = 0;

  /// The numbers of passes over the tetrahedra (priority: one for each layer), and of layers.
  int Passes = 0;
  int Layers = 0;
  /// The numbers of tetrahedra in cycles of visibility, and of places where a line of sight leaves
  /// the mesh and enters it again (relations added across gaps), both for MPVONC.
  vtkIdType Cycles = 0;
  vtkIdType Gaps = 0;
  /// Whether this picture sorted, and whether face adjacency is kept.
  bool Sorted = false;
  bool HasAdjacency = false;

  /// The bytes sent to the graphics card for this picture: static data, order, textures of the
  /// picture.
  vtkIdType UploadedStaticBytes = 0;
  vtkIdType UploadedOrderBytes = 0;
  vtkIdType UploadedImageBytes = 0;
  /// The number of off-screen buffers kept, and the bytes in main memory and in buffers of the
  /// graphics card.
  int Buffers = 0;
  vtkIdType BufferBytes = 0;
  vtkIdType MemoryBytes = 0;

  /// The level of detail: the number of pixels of the picture for each that was computed (1, 2, 4,
  /// ... along an edge), and the number of tetrahedra of which one was drawn. Both are 1 for a full
  /// picture.
  int PixelStride = 1;
  int TetrahedronStride = 1;
  /// The number of control points of the transfer functions, after reduction to straight pieces.
  int ControlPoints = 0;
  /// Seconds of this picture, until the graphics card was done where AutoAdjustLevelOfDetail is on.
  double Seconds = 0.0;

  /// Whether values of the input were taken anew for this picture, and whether the mesh was: where
  /// points and tetrahedra are those of the last picture, as in a new time step of the same mesh,
  /// the mesh, its adjacency, boundary, order and what was sent of them stay.
  bool ValuesTaken = false;
  bool MeshMade = false;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
