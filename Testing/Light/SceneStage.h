// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneStage_h
#define SceneStage_h

#include "Support/Pictures/VolumeStage.h"

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

/// A box, a closed mesh of six faces.
vtkSmartPointer<vtkActor> MakeBox(const std::array<double, 6>& bounds);
/// A rectangle from a corner along two edges, of one polygon.
vtkSmartPointer<vtkActor> MakeRectangle(const std::array<double, 3>& origin,
  const std::array<double, 3>& first, const std::array<double, 3>& second);
/// A square around a place, perpendicular to a direction, that lets light through; orange.
vtkSmartPointer<vtkActor> MakePane(const std::array<double, 3>& center,
  const std::array<double, 3>& normal, double edge, double opacity = 0.5);
vtkSmartPointer<vtkActor> MakeBall(const std::array<double, 3>& center, double radius, int sides);
/// White, without ambient and specular light; without input where there is no output.
vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithmOutput* output);

/// White light of intensity 1 along a direction, with full shadows.
vtkSmartPointer<vtkLight> MakeSun(const std::array<double, 3>& direction);
/// The same from a place to another, without cone.
vtkSmartPointer<vtkLight> MakeLamp(
  const std::array<double, 3>& position, const std::array<double, 3>& focus);

/**
 * @class   SceneStage
 * @brief   a window out of sight with actors and a volume that vtkShadowedScenePass draws
 *
 * The camera looks down at z = 0 without perspective, one unit of the picture is one of x and y:
 * the picture's middle is the origin.
 */
class SceneStage
{
public:
  /// \a pixels along each edge of a picture that shows so many units.
  explicit SceneStage(int pixels = 256, double size = 2.0);
  ~SceneStage();

  void Add(vtkActor* actor) { this->Stage.AddActor(actor); }
  /// Puts homogeneous smoke of an extinction into a box, of so many voxels along each axis; the
  /// first one is drawn by Mapper.
  void AddSmoke(const std::array<double, 6>& bounds, double extinction, int cells = 8);

  /// Draws by the pass, or without it.
  RgbaPicture Draw(bool hasPass = true);
  /// The first channel at a place of a picture.
  double At(const RgbaPicture& picture, double x, double y) const;
  /// Where the first channel crosses \a level between two places at \a y, by linear interpolation
  /// of pixels.
  double FindEdge(const RgbaPicture& picture, double from, double to, double y, double level) const;
  /// Looks at the origin along a direction.
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
