// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAreaLightRepresentation_h
#define vtkAreaLightRepresentation_h

#include "InterlumeWidgetsModule.h" // for the export macro
#include "vtkLightRepresentation.h"
#include "vtkNew.h" // for what is drawn

#include <array> // for handles

class vtkActor;
class vtkAreaLight;
class vtkPolyData;
class vtkSphereSource;

/**
 * @class   vtkAreaLightRepresentation
 * @brief   shows where a vtkAreaLight is, with handles for its place, direction and size
 *
 * It draws the outline of the emitter and a line from its centre to the focal point, and four
 * handles, which keep their size in pixels: the centre, the focal point, and one just beyond the
 * right and one beyond the upper edge. Each is dragged in the plane that faces the camera. Dragging
 * the centre moves the light, which goes on shining at the focal point; dragging a handle at an
 * edge away from the centre by d makes the emitter wider or higher by 2 d, never less than 0. The
 * handle under the cursor is red.
 *
 * vtkLightWidget moves it, as any vtkLightRepresentation. Positional and ConeAngle are not shown.
 *
 * @sa vtkAreaLight vtkLightWidget
 */
class INTERLUMEWIDGETS_EXPORT vtkAreaLightRepresentation : public vtkLightRepresentation
{
public:
  static vtkAreaLightRepresentation* New();
  vtkTypeMacro(vtkAreaLightRepresentation, vtkLightRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What is dragged, beside what vtkLightRepresentation has.
  enum
  {
    ScalingWidth = ScalingConeAngle + 1,
    ScalingHeight
  };

  ///@{
  /**
   * The light's shape, size and direction up, with the defaults and valid values of vtkAreaLight.
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
   * Computes the place of a handle: MovingLight, MovingFocalPoint, ScalingWidth or ScalingHeight.
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

  /// Gives the light the position and focal point that the superclass has.
  void UpdateLight();
  void BuildOutline();
  /// Computes the point of the world under the cursor, as far away as the handle that is dragged.
  void GetDraggedPoint(const double eventPosition[2], double point[3]);

  vtkNew<vtkAreaLight> Light;
  vtkNew<vtkPolyData> Outline;
  vtkNew<vtkActor> OutlineActor;
  std::array<Handle, 4> Handles;
  /// Where the drag began: the handle, the cursor as far away as it, and the emitter's size.
  double StartHandle[3] = { 0.0, 0.0, 0.0 };
  double StartPoint[3] = { 0.0, 0.0, 0.0 };
  double StartSize[2] = { 0.0, 0.0 };
};

#endif
