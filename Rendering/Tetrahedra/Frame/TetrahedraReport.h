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
 * @brief   values that vtkTimeWeightedTetrahedraMapper reports for its last image
 *
 * Counts are 0 for steps that were not executed. Strings are empty before the first image.
 */
struct TetrahedraReport
{
  /// Values of the enums RenderPaths, BlendModes, SortModes and SilhouetteShaders of
  /// vtkTimeWeightedTetrahedraMapper, after automatic choices were resolved. SilhouetteShader is 0
  /// with the software path.
  int RenderPath = 0;
  int BlendMode = 0;
  int SortMode = 0;
  int SilhouetteShader = 0;
  /// The reason for each choice.
  std::string PathReason;
  std::string BlendReason;
  std::string SortReason;
  std::string ShaderReason;
  /// Features of the shader or kernel that ran, separated by spaces, such as `scalars perspective
  /// composite`. `delta-t` and `surface` are listed only if they are used.
  std::string Features;

  /// Number of tetrahedra in the input, of tetrahedra drawn (in view, at this level of detail), and
  /// of tetrahedra cut by the near plane or a clipping plane.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraDrawn = 0;
  vtkIdType TetrahedraClipped = 0;
  /// Number of tetrahedra skipped because their volume is zero, and of tetrahedra skipped because a
  /// coordinate or array value at a corner is NaN or infinite.
  vtkIdType FlatTetrahedra = 0;
  vtkIdType NonFiniteTetrahedra = 0;
  /// Number of boundary triangles drawn, and of input triangles that are not faces of tetrahedra.
  vtkIdType BoundaryTriangles = 0;
  vtkIdType UnmatchedTriangles = 0;

  /// Number of processes whose partitions were combined in this image. 0 if this process drew only
  /// its own partition, even if images are composited afterward.
  int Processes = 0;

  /// Number of passes over the tetrahedra (one for each layer in PRIORITY_BLEND), and number of
  /// layers.
  int Passes = 0;
  int Layers = 0;
  /// Number of tetrahedra in visibility cycles, and of ordering relations across gaps, where a view
  /// ray exits the mesh and enters it again. Both are counted only with MPVONC_SORT.
  vtkIdType Cycles = 0;
  vtkIdType Gaps = 0;
  /// Sorted is true if tetrahedra were sorted for this image, HasAdjacency if face adjacency is
  /// cached.
  bool Sorted = false;
  bool HasAdjacency = false;

  /// Bytes uploaded to the GPU for this image: static data, drawing order, and images computed on
  /// the CPU.
  vtkIdType UploadedStaticBytes = 0;
  vtkIdType UploadedOrderBytes = 0;
  vtkIdType UploadedImageBytes = 0;
  /// Number of off-screen buffers, bytes of GPU buffers, and bytes in main memory.
  int Buffers = 0;
  vtkIdType BufferBytes = 0;
  vtkIdType MemoryBytes = 0;

  /// Level of detail: number of viewport pixels per computed pixel in x and in y (1, 2 or 4), and
  /// number of tetrahedra per tetrahedron of the subset. Both are 1 in full detail.
  int PixelStride = 1;
  int TetrahedronStride = 1;
  /// Number of control points of the piecewise linear transfer functions.
  int ControlPoints = 0;
  /// Seconds to render this image, including GPU time if AutoAdjustLevelOfDetail is on.
  double Seconds = 0.0;

  /// ValuesUpdated is true if input values were read again for this image, MeshRebuilt if the mesh
  /// was rebuilt. If points and tetrahedra did not change, as in a new time step of the same mesh,
  /// the mesh, its adjacency, boundary, order and GPU buffers are reused.
  bool ValuesUpdated = false;
  bool MeshRebuilt = false;

  /// Replaces all values of a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
