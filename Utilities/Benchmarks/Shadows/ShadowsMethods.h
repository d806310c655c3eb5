// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsMethods_h
#define ShadowsMethods_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Support/Images/ShadowScene.h"
#include "Support/Images/VolumeStage.h"

#include "vtkShadowedSliceMapper.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkCamera;
class vtkVolumeMapper;

/**
 * Rendering methods that the suite `shadows` compares.
 */
namespace shadows
{
/// Names of the baselines: vtkGPUVolumeRayCastMapper without and with volumetric shadows.
extern const char* const GpuBaseline;
extern const char* const GpuShadowsBaseline;

/**
 * A volume with one mapper, in a window that several methods share. Only one method is visible at a
 * time. Switching between methods therefore rebuilds nothing, and compiled shaders are shared.
 */
class Method
{
public:
  /// The stage must outlive the method.
  Method(
    reference::VolumeStage& stage, const reference::ShadowScene& scene, vtkVolumeMapper* mapper);
  ~Method();
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// Returns work that renders one frame with \a threads threads of vtkSMPTools and waits until the
  /// frame is complete. The camera rotates by half a degree per frame. The method must outlive the
  /// work.
  BenchWork GetFrame(int threads);
  /// Returns the image at the initial camera position as floating-point values.
  reference::RgbaImage Capture();

  /// Returns the mapper if it is a vtkShadowedSliceMapper, or null otherwise.
  vtkShadowedSliceMapper* GetSliceMapper();

private:
  void Show(vtkCamera* camera);

  reference::VolumeStage& Stage;
  reference::ShadowScene Scene;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  int Frames = 0;
};

using MethodPointer = std::unique_ptr<Method>;

/// Creates a method with a vtkShadowedSliceMapper at full quality. \a set may change the mapper's
/// settings.
MethodPointer MakeSliceMethod(reference::VolumeStage& stage, const reference::ShadowScene& scene,
  const std::function<void(vtkShadowedSliceMapper*)>& set = nullptr);

/**
 * Create a method with a vtkGPUVolumeRayCastMapper that casts one ray per pixel, with the given
 * sample distance in voxels. MakeShadowRayMethod() also calls EnableGpuShadows() and turns Shade
 * on, which the shadows require. It returns null if this version of VTK has no volumetric shadows.
 */
MethodPointer MakeRayCastMethod(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);
MethodPointer MakeShadowRayMethod(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);

/// A method with one setting, and its measured time and error.
struct Setting
{
  std::string Name;
  double Parameter = 0.0;
  MethodPointer Drawn;
  BenchSeconds Seconds = {};
  double Error = 0.0;
};

/// Measures the frame times of all settings, which run alternately.
void MeasureFrames(std::vector<Setting>& settings, int threads, int repeats);

/// Adds the counts of the last frame, such as slices, passes and bytes, from \a report to \a row.
void AddReport(vtkInterlumeReport* report, BenchRow& row);
}

#endif
