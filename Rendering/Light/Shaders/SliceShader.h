// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceShader_h
#define interlume_SliceShader_h

#include "Shaders/VolumeRenderState.h"

#include <string>

class vtkShaderProgram;

namespace interlume
{

/**
 * @class   SliceShader
 * @brief   chooses the features of an image's programs, and sets their uniforms
 */
class SliceShader
{
public:
  /// Fragments of a slab: all; or those of thin matter and of none, or of none alone, which need no
  /// light, and then those of thick matter, or all that are left.
  enum Parts
  {
    ALL,
    THIN,
    EMPTY,
    THICK
  };
  /// Returns the largest extinction of a volume in unit space.
  static double GetLargestExtinction(const VolumeRenderState& frame);
  /// Returns the same, or 0 if opacity does not depend on values only.
  static double GetRampExtinction(const VolumeRenderState& frame);
  /// Returns whether thick matter is drawn by itself in a sweep: where there is some, and a light
  /// seen through a plane casts shadows in it.
  static bool HasThickPart(const VolumeRenderState& frame, std::size_t sweep);
  /// Whether what is empty is drawn by itself, before all else, where no matter is thick: software
  /// OpenGL runs all of a shader for fragments that are discarded, unless the test of depth drops
  /// them.
  static bool HasEmptyPart(const VolumeRenderState& frame, std::size_t sweep);
  /// Whether there is thin matter too: where some opacity above 0 makes whole slabs thin.
  static bool HasThinPart(const VolumeRenderState& frame, std::size_t sweep);

  /**
   * Returns the source of the shader for the picture's fragments in a sweep. The first sweep has
   * all lights without shadows and the ambient light as well.
   */
  static std::string GetEyeSource(
    const VolumeRenderState& frame, std::size_t sweep, bool isOccluded, Parts part);
  /// Returns the source of the shader for the fragments of a light's buffer, different for each
  /// light, which so keeps its uniforms from slab to slab. If \a isThick, the sweep has thick
  /// matter.
  static std::string GetLightSource(
    const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light, bool isThick);

  /// Returns the source of the shader for the surfaces of a scene that a light shines on,
  /// different for each light.
  static std::string GetReceiverSource(
    const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light);

  /// Returns the names of the features in the sources, for the report.
  static std::string GetNames(const VolumeRenderState& frame, bool isOccluded);

  ///@{
  /// Sets the uniforms that are the same for all slabs of a sweep.
  static void SetEyeUniforms(
    vtkShaderProgram* program, const VolumeRenderState& frame, std::size_t sweep);
  static void SetLightUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  static void SetReceiverUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  static void SetLayerPointUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light);
  ///@}

  /// Returns the lights that the picture's fragments of a sweep see: indices in the picture's list,
  /// those with buffers first and in their order.
  static std::vector<int> GetLightsOf(const VolumeRenderState& frame, std::size_t sweep);
};

}

#endif
