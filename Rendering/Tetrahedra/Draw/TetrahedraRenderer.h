// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraRenderer_h
#define interlume_TetrahedraRenderer_h

#include "Common/Error.h"
#include "Draw/LevelOfDetail.h"
#include "Frame/BoundaryShading.h"
#include "Frame/PlaneClip.h"
#include "Frame/TetrahedraFrame.h"
#include "Frame/TetrahedraReport.h"
#include "Mesh/MeshBuilder.h"
#include "Mesh/TetrahedraBuilder.h"
#include "Order/BoundaryFaces.h"
#include "Order/TetrahedraOrder.h"
#include "Software/SoftwareRasterizer.h"
#include "View/TetrahedraDepth.h"

#include "vtkType.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataSet;
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTimeWeightedTetrahedraMapper;
class vtkUnstructuredGrid;
class vtkVolume;
class vtkVolumeProperty;
class vtkWindow;

namespace interlume
{

class PieceExchange;

/**
 * @class   TetrahedraRenderer
 * @brief   draws one picture: makes what has changed anew, makes the choices, has one of the paths
 * draw
 */
class TetrahedraRenderer
{
public:
  TetrahedraRenderer();
  ~TetrahedraRenderer();

  /// The mapper, whose settings are read, and what it has found.
  struct Request
  {
    vtkTimeWeightedTetrahedraMapper* Mapper = nullptr;
    vtkUnstructuredGrid* Grid = nullptr;
    TetrahedraArrays Arrays;
    vtkDataSet* Boundary = nullptr;
    /// The pieces of other processes that this one is drawn with; null where it is drawn alone.
    /// With them Grid may be null.
    const PieceExchange* Pieces = nullptr;
  };

  /**
   * Draws and reports. Returns an error if something cannot be drawn.
   */
  Error Render(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// The resources of one window's context.
  struct WindowResources;
  struct DrawnState;

  WindowResources& GetResources(vtkWindow* window);
  /// Rebuilds the mesh, or only its values if the mesh is the same. Returns an error if the grid
  /// cannot be drawn.
  Error UpdateMesh(const Request& request, TetrahedraReport& report);
  void CountTetrahedra(const Request& request, TetrahedraReport& report) const;
  Error UpdateColors(const Request& request, vtkVolumeProperty* property, double unit);
  void ChooseBlend(const Request& request, TetrahedraReport& report);
  void ChoosePath(const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report);
  void ChooseShader(
    const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report);
  void ChooseSort(const Request& request, TetrahedraReport& report);
  /// Returns the level of detail, which is 0 for whole pictures.
  int ChooseLevel(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  /// Updates the changed parts of this image. Returns an error if it cannot be drawn.
  Error UpdateFrame(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  /// Cuts the mesh at the near plane and the clipping planes, and sets the order that is drawn.
  /// Returns an error if a clipping plane is not valid.
  Error ClipMesh(const Request& request, const std::vector<std::uint32_t>* order);
  void DrawFrame(
    vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report);
  bool FindOneColor() const;
  const std::vector<std::uint32_t>* UpdateOrder(const Request& request, TetrahedraReport& report);
  Error DrawWithOpenGL(
    vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report);
  void DrawInSoftware(vtkRenderer* renderer, WindowResources& resources, TetrahedraReport& report);
  /// Draws the picture of all pieces, together with the other processes.
  Error RenderPieces(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    vtkOpenGLRenderWindow& window, TetrahedraReport& report);
  /// Returns the order of the processes from the nearest on; none where the blend mode needs none.
  static std::vector<int> FindPieceOrder(
    vtkRenderer* renderer, vtkVolume* volume, const PieceExchange& pieces);
  /// Updates the changed parts of this process's piece. Returns an error if it cannot be drawn.
  Error UpdatePiece(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  void Select(vtkRenderer* renderer, vtkHardwareSelector* selector, WindowResources& resources);
  void DrawSelection(
    vtkRenderer* renderer, vtkHardwareSelector* selector, WindowResources& resources);
  void ReadDepth(vtkRenderer* renderer);
  /// Takes the depth that was read into the frame.
  void PlaceDepth();
  /// Returns whether a point of the mesh is beyond the far plane.
  bool IsCutByFarPlane() const;
  void UpdateBoundary(vtkRenderer* renderer, const Request& request, TetrahedraReport& report);
  std::string GetFeatures() const;
  vtkIdType GetMemoryBytes() const;

  /// The data that mesh and colours were made of.
  struct MeshKey
  {
    vtkUnstructuredGrid* Grid = nullptr;
    vtkMTimeType Time = 0;
    TetrahedraArrays Arrays;
  };
  MeshKey MeshState;
  vtkVolumeProperty* Property = nullptr;
  vtkMTimeType PropertyTime = 0;
  double ColorUnit = 0.0;
  /// Whether all is of one colour, so that order does not matter.
  bool HasOneColor = false;

  /// The data that the boundary was made of.
  vtkDataSet* Boundary = nullptr;
  vtkMTimeType BoundaryTime = 0;
  BoundaryFaces::Counts BoundaryCounts;
  BoundaryShading Shading;

  TetrahedraMesh Mesh;
  TetrahedraFields Fields;
  PiecewiseLinearTransfer Pieces;
  interlume::MeshBuilder MeshBuilder;
  TetrahedraOrder Order;
  PlaneClip Clip;
  TetrahedraDepth Depth;
  TetrahedraFrame Frame;
  SoftwareRasterizer Rasterizer;
  interlume::LevelOfDetail LevelOfDetail;
  /// The path and the size of the viewport that the times of Level were measured with.
  std::array<int, 3> LevelConditions{};
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
};

}

#endif
