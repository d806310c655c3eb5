// SPDX-License-Identifier: BSD-3-Clause
#ifndef Panel_h
#define Panel_h

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVector.h"

#include <string>
#include <vector>

class vtkProp;
class vtkRenderWindow;

namespace gallery
{
/**
 * One view within a picture: its props, its camera, its caption. Made by Stage::AddPanel.
 *
 * The camera is given as a direction only; the stage fits it so that the props fill the panel.
 */
class Panel
{
public:
  explicit Panel(const std::string& caption);

  const std::string& GetCaption() const { return this->Caption; }

  /**
   * Adds an opaque surface (vtkActor) or a volume (vtkVolume).
   */
  void Add(vtkProp* prop);

  /**
   * The eye looks along minus \a from, with \a up pointing up. Default from (0, -1, 0), up (0, 0,
   * 1).
   */
  void LookFrom(const vtkVector3d& from, const vtkVector3d& up);

  /**
   * Uses the camera of another panel; both are fitted to the props of both.
   */
  void LookAs(Panel& other);

  /**
   * The camera is fitted to \a bounds instead of the props; what lies around them may run out of
   * the picture.
   */
  void Frame(const vtkBoundingBox& bounds) { this->FramedBox = bounds; }

  /**
   * Lights of the panel's own in place of the look's, of any type and place.
   */
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights);

  /**
   * Draws without perspective, so that equal things look equal everywhere. Default: in perspective.
   */
  void UseParallelProjection() { this->Camera->ParallelProjectionOn(); }

  /**
   * Default: Background() of the look.
   */
  void SetBackground(const vtkColor3d& colour);

  /**
   * Ambient occlusion of the surfaces: reach as a share of the diagonal of the panel's props, 0 for
   * none. Default 0.05; none where the panel has no surface.
   */
  void SetAmbientOcclusion(double reach) { this->OcclusionReach = reach; }

  ///@{
  /**
   * For the stage: the renderer, the camera, what fitting it needs, and the drawing of width x
   * height pixels. GetPixels() is the size drawn last.
   */
  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkCamera* GetCamera() const { return this->Camera; }
  bool UsesAmbientOcclusion() const;
  std::vector<vtkVector3d> GetPoints() const;
  void Fit(const std::vector<vtkVector3d>& points, double aspect);
  vtkSmartPointer<vtkImageData> Draw(int width, int height);
  /// Draws in a window that shows this panel alone, and stays for the next drawing.
  vtkSmartPointer<vtkImageData> DrawIn(vtkRenderWindow* window);
  vtkIdType GetPixels() const { return this->Pixels; }
  ///@}

private:
  vtkBoundingBox GetBox() const;
  void PreparePasses();

  std::string Caption;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkCamera> Camera;
  vtkBoundingBox FramedBox;
  vtkIdType Pixels = 0;
  double OcclusionReach = 0.05;
};
}

#endif
