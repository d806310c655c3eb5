// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraScene_h
#define TetrahedraScene_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Images/VolumeStage.h"

#include "vtkCamera.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

/**
 * Scene of the suite `tetrahedra`.
 */
namespace tetrahedra
{
/// Returns the value of the gyroid field at a point, from -1.5 to 1.5. See MakeAnalyticCases().
double GetField(double x, double y, double z);
/// Return the bounds of the cube [low, high]^3 in which the field is defined.
double GetLow();
double GetHigh();

/**
 * Returns the field sampled on a grid of cubes^3 cubes, each split into five tetrahedra. The cell
 * array `IntervalId` assigns the tetrahedra to four layers.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cubes);

/**
 * Returns a property with piecewise linear transfer functions, each with a node inside the scalar
 * range. Opacities are at most 1, so that vtkProjectedTetrahedraMapper supports them.
 */
vtkSmartPointer<vtkVolumeProperty> MakeProperty();

/**
 * Returns a perspective camera that looks at the cube at an oblique angle.
 */
vtkSmartPointer<vtkCamera> MakeCamera();

/**
 * A window shared by several mappers, so that all of them render in the same OpenGL context.
 */
class SharedStage
{
public:
  explicit SharedStage(int pixels);

  /// Returns a function that renders one frame with \a mapper and waits until the frame is
  /// complete. The camera rotates by half a degree per frame. The mapper must outlive the function.
  BenchWork MakeRenderWork(vtkUnstructuredGridVolumeMapper* mapper);
  /// Returns the image of \a mapper at the initial camera position as floating-point values.
  reference::RgbaImage Capture(vtkUnstructuredGridVolumeMapper* mapper);
  /// Returns the same image as Capture(), but renders it in a separate window. The mapper must not
  /// have rendered before.
  reference::RgbaImage CaptureSeparately(vtkUnstructuredGridVolumeMapper* mapper) const;

  reference::VolumeStage& GetStage() { return this->Stage; }
  std::array<int, 2> GetSize() const { return this->Size; }
  vtkVolumeProperty* GetProperty() { return this->Property; }

private:
  std::array<int, 2> Size;
  reference::VolumeStage Stage;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  int Frames = 0;
};
}

#endif
