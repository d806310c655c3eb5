// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraScene_h
#define TetrahedraScene_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkCamera.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

/**
 * What the suite `tetrahedra` draws.
 */
namespace tetrahedra
{
/// The field: the gyroid of AnalyticCases, of values from -1.5 to 1.5.
double GetField(double x, double y, double z);
/// The cube that it fills is [Low, High]^3.
double GetLow();
double GetHigh();

/**
 * The field on cubes^3 cubes of five tetrahedra, with four layers in the cell array `IntervalId`.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cubes);

/**
 * Straight transfer functions with nodes inside the range, opacity at most 1: what
 * vtkProjectedTetrahedraMapper can hold.
 */
vtkSmartPointer<vtkVolumeProperty> MakeProperty();

/**
 * A perspective view of the cube, at a slant.
 */
vtkSmartPointer<vtkCamera> MakeCamera();

/**
 * Lets mappers take turns in one window, so that all are drawn by the same context.
 */
class Theatre
{
public:
  explicit Theatre(int pixels);

  /// One frame of a mapper, from where the camera has moved on by half a degree, until it is done.
  /// The mapper must outlive the work.
  BenchWork FrameOf(vtkUnstructuredGridVolumeMapper* mapper);
  /// The picture of a mapper from the camera's first position, in floating point.
  reference::RgbaPicture Capture(vtkUnstructuredGridVolumeMapper* mapper);
  /// The same on a stage of its own, for a mapper that has not drawn before.
  reference::RgbaPicture CaptureApart(vtkUnstructuredGridVolumeMapper* mapper) const;

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
