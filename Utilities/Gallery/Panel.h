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
 * A view within an image, with its props, camera and caption. Created by Stage::AddPanel.
 *
 * The scene sets only the direction of the camera. The stage fits the camera so that the props fill
 * the panel.
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
   * Sets the direction from the focal point to the camera, and the view-up vector. Default: (0, -1,
   * 0) and (0, 0, 1).
   */
  void LookFrom(const vtkVector3d& from, const vtkVector3d& up);

  /**
   * Shares the camera of another panel. The camera is fitted to the props of both panels.
   */
  void ShareCamera(Panel& other);

  /**
   * Fits the camera to \a bounds instead of the props, which may extend past the edges of the
   * panel.
   */
  void Frame(const vtkBoundingBox& bounds) { this->FramedBox = bounds; }

  /**
   * Replaces the default lights. Lights of any type are supported.
   */
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights);

  /**
   * Uses a parallel projection, in which the apparent size of objects does not depend on their
   * distance. Default: perspective.
   */
  void UseParallelProjection() { this->Camera->ParallelProjectionOn(); }

  /**
   * Sets the background color, or a vertical gradient from \a lower to \a upper. Default:
   * Background(). The stage leaves a gap between panels with another background.
   */
  void SetBackground(const vtkColor3d& color);
  void SetBackground(const vtkColor3d& lower, const vtkColor3d& upper);

  /**
   * Sets the radius of ambient occlusion as a fraction of the diagonal of the props' bounds. 0
   * turns it off. It has no effect on panels without surfaces. Default: 0.05.
   */
  void SetAmbientOcclusion(double reach) { this->OcclusionReach = reach; }

  ///@{
  /**
   * Used by Stage. GetPoints() returns the points to which Fit() fits the camera.
   * GetNumberOfPixels() returns the number of pixels drawn by the last call of Draw().
   */
  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkCamera* GetCamera() const { return this->Camera; }
  bool UsesAmbientOcclusion() const;
  std::vector<vtkVector3d> GetPoints() const;
  void Fit(const std::vector<vtkVector3d>& points, double aspect);
  /// Draws the panel in a new window. Lines and points are \a lineScale times as large as their
  /// properties specify.
  vtkSmartPointer<vtkImageData> Draw(int width, int height, double lineScale = 1.0);
  /// Draws the panel in \a window, which must contain only this panel's renderer. The window can be
  /// reused.
  vtkSmartPointer<vtkImageData> DrawIn(vtkRenderWindow* window);
  vtkIdType GetNumberOfPixels() const { return this->Pixels; }
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
