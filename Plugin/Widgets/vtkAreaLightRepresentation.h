// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAreaLightRepresentation_h
#define vtkAreaLightRepresentation_h

#include "InterlumeWidgetsModule.h" // for the export macro
#include "vtkLightRepresentation.h"
#include "vtkNew.h" // for actors

#include <array> // for handles

class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkSphereSource;

/**
 * @class   vtkAreaLightRepresentation
 * @brief   represent a vtkAreaLight with handles for its position, direction and size
 *
 * The representation shows the outline of the emitter and a line from its center to the focal
 * point. Four handles of constant size in pixels are at the center, at the focal point, and just
 * outside the right and the upper edge of the emitter. Handles are dragged parallel to the view
 * plane. Dragging the center moves the light but not the focal point. Dragging an edge handle
 * outward by d increases the width or height of the emitter by 2 d; dragging it inward decreases
 * this size, down to 0. The handle under the cursor is red.
 *
 * Use it with vtkLightWidget, like any vtkLightRepresentation. Positional and ConeAngle are not
 * shown.
 *
 * @sa vtkAreaLight vtkLightWidget
 */
class INTERLUMEWIDGETS_EXPORT vtkAreaLightRepresentation : public vtkLightRepresentation
{
public:
  static vtkAreaLightRepresentation* New();
  vtkTypeMacro(vtkAreaLightRepresentation, vtkLightRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Interaction states in addition to those of vtkLightRepresentation.
  enum
  {
    ScalingWidth = ScalingConeAngle + 1,
    ScalingHeight
  };

  ///@{
  /**
   * Set/Get the shape, the size in world units and the up direction of the light. Defaults and
   * valid values are those of vtkAreaLight.
   */
  void SetShape(int shape);
  int GetShape();
  void SetWidth(double width);
  double GetWidth();
  void SetHeight(double height);
  double GetHeight();
  void SetViewUp(double x, double y, double z);
  double* GetViewUp() VTK_SIZEHINT(3);
  ///@}

  /**
   * Compute the world position of a handle: MovingLight, MovingFocalPoint, ScalingWidth or
   * ScalingHeight.
   */
  void GetHandlePosition(int handle, double position[3]);

  void BuildRepresentation() override;
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void StartWidgetInteraction(double eventPosition[2]) override;
  void WidgetInteraction(double eventPosition[2]) override;
  double* GetBounds() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;

protected:
  vtkAreaLightRepresentation();
  ~vtkAreaLightRepresentation() override;

private:
  vtkAreaLightRepresentation(const vtkAreaLightRepresentation&) = delete;
  void operator=(const vtkAreaLightRepresentation&) = delete;

  struct Handle
  {
    int State;
    vtkNew<vtkSphereSource> Sphere;
    vtkNew<vtkActor> Actor;
  };

  /// Copies the position and the focal point of the superclass to the light.
  void UpdateLight();
  void BuildOutline();
  /// Computes the world position under the cursor, at the depth of the dragged handle.
  void GetDraggedPoint(const double eventPosition[2], double point[3]);

  vtkNew<vtkAreaLight> Light;
  vtkNew<vtkPolyData> Outline;
  vtkNew<vtkActor> OutlineActor;
  std::array<Handle, 4> Handles;
  /// State at the start of the drag: positions of the handle and of the cursor at its depth, and
  /// size of the emitter.
  double StartHandle[3] = { 0.0, 0.0, 0.0 };
  double StartPoint[3] = { 0.0, 0.0, 0.0 };
  double StartSize[2] = { 0.0, 0.0 };
};

#endif
