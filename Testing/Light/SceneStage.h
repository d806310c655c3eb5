// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneStage_h
#define SceneStage_h

#include "Support/Images/VolumeStage.h"

#include "vtkNew.h"
#include "vtkShadowedScenePass.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkActor;
class vtkAlgorithmOutput;
class vtkLight;
class vtkPolyData;
class vtkShadowedSliceMapper;

namespace reference
{

/// Creates a closed box of six faces.
vtkSmartPointer<vtkActor> MakeBox(const std::array<double, 6>& bounds);
/// Creates a rectangle of one polygon from a corner and two edges.
vtkSmartPointer<vtkActor> MakeRectangle(const std::array<double, 3>& origin,
  const std::array<double, 3>& first, const std::array<double, 3>& second);
/// Creates an orange, translucent square around a center, perpendicular to a normal.
vtkSmartPointer<vtkActor> MakeTranslucentSquare(const std::array<double, 3>& center,
  const std::array<double, 3>& normal, double edge, double opacity = 0.5);
vtkSmartPointer<vtkActor> MakeSphereActor(
  const std::array<double, 3>& center, double radius, int sides);
/// Creates a white actor without ambient and specular light. \a output may be null.
vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithmOutput* output);

/// Creates a white directional light of intensity 1 with full shadows.
vtkSmartPointer<vtkLight> MakeSun(const std::array<double, 3>& direction);
/// Creates a white point light of intensity 1 with full shadows.
vtkSmartPointer<vtkLight> MakePointLight(
  const std::array<double, 3>& position, const std::array<double, 3>& focus);

/**
 * @class   SceneStage
 * @brief   an offscreen window with actors and volumes, drawn by vtkShadowedScenePass
 *
 * The camera looks along -z in parallel projection. The center of the frame shows the origin, with
 * x to the right and y up.
 */
class SceneStage
{
public:
  /// Creates a square window with \a pixels per edge. The view covers \a size world units per edge.
  explicit SceneStage(int pixels = 256, double size = 2.0);
  ~SceneStage();

  void Add(vtkActor* actor) { this->Stage.AddActor(actor); }
  /// Adds homogeneous smoke in a box, with \a cells voxels along each axis. The member Mapper draws
  /// the first volume.
  void AddSmoke(const std::array<double, 6>& bounds, double extinction, int cells = 8);

  /// Draws a frame, with vtkShadowedScenePass if \a hasPass is true.
  RgbaImage Draw(bool hasPass = true);
  /// Returns the first channel of the pixel that shows (x, y).
  double At(const RgbaImage& image, double x, double y) const;
  /// Returns the x coordinate between \a from and \a to at which the first channel crosses \a
  /// level, along the horizontal line at \a y. Interpolates linearly between pixels.
  double FindEdge(const RgbaImage& image, double from, double to, double y, double level) const;
  /// Points the camera at the origin, with the view direction \a direction.
  void LookAlong(const std::array<double, 3>& direction);

  vtkInterlumeReport* GetReport() const { return this->Pass->GetReport(); }

  VolumeStage Stage;
  vtkNew<vtkShadowedScenePass> Pass;
  vtkNew<vtkShadowedSliceMapper> Mapper;

private:
  int Pixels;
  double Size;
};

}

#endif
