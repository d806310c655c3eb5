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
/// Returns the field: the gyroid of AnalyticCases, with values from -1.5 to 1.5.
double GetField(double x, double y, double z);
/// The field is defined in the cube [Low, High]^3.
double GetLow();
double GetHigh();

/**
 * Returns the field on cubes^3 cubes, each split into five tetrahedra. The cell array `IntervalId`
 * distinguishes four layers.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cubes);

/**
 * Returns piecewise linear transfer functions, each with a node inside the scalar range. Opacities
 * are at most 1, so that vtkProjectedTetrahedraMapper supports them.
 */
vtkSmartPointer<vtkVolumeProperty> MakeProperty();

/**
 * Returns an oblique perspective view of the cube.
 */
vtkSmartPointer<vtkCamera> MakeCamera();

/**
 * A window shared by several mappers, so that all render in the same context.
 */
class SharedStage
{
public:
  explicit SharedStage(int pixels);

  /// Returns a function that renders one frame of a mapper and waits until it is complete. The
  /// camera rotates by half a degree per frame. The mapper must outlive the function.
  BenchWork FrameOf(vtkUnstructuredGridVolumeMapper* mapper);
  /// Returns the image of a mapper at the initial camera position, in floating point.
  reference::RgbaImage Capture(vtkUnstructuredGridVolumeMapper* mapper);
  /// Returns the image that Capture() returns, but renders in a separate window. The mapper must
  /// not have rendered before.
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
