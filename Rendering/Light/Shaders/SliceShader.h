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
 * @brief   selects the features of an image's shader programs and sets their uniforms
 */
class SliceShader
{
public:
  /// The fragments of a slab that a program draws. EMPTY programs draw only empty fragments, which
  /// need no lighting; THIN programs also draw thin ones. THICK programs draw all others.
  enum Parts
  {
    ALL,
    THIN,
    EMPTY,
    THICK
  };
  /// Returns the maximum extinction of a volume in unit space.
  static double GetLargestExtinction(const VolumeRenderState& frame);
  /// Returns the maximum extinction, or 0 if opacity depends on more than the scalar values.
  static double GetRampExtinction(const VolumeRenderState& frame);
  /// Returns true if a sweep draws thick fragments separately: if slabs can be thick, and at least
  /// one light that is not inside or near the volume casts shadows.
  static bool HasThickPart(const VolumeRenderState& frame, std::size_t sweep);
  /// Returns true if a sweep without thick fragments draws empty fragments first. Software OpenGL
  /// executes the complete shader for discarded fragments, unless the depth test rejects them.
  static bool HasEmptyPart(const VolumeRenderState& frame, std::size_t sweep);
  /// Returns true if thin fragments exist: if there is no thick part, or if a slab with the
  /// smallest extinction above 0 is thin.
  static bool HasThinPart(const VolumeRenderState& frame, std::size_t sweep);

  /**
   * Returns the source of the image fragment shader of a sweep. The first sweep also includes
   * ambient light and all lights without shadows.
   */
  static std::string GetImageShaderSource(
    const VolumeRenderState& frame, std::size_t sweep, bool isOccluded, Parts part);
  /// Returns the source of the fragment shader of a light buffer. The source differs per light, so
  /// that each program keeps its uniforms from slab to slab. \a isThick is true if the sweep has
  /// thick fragments.
  static std::string GetLightBufferShaderSource(
    const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light, bool isThick);

  /// Returns the source of the shader for surfaces of a scene that receive light from the volumes.
  /// The source differs per light.
  static std::string GetReceiverShaderSource(
    const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light);

  /// Returns the names of the features in use, for the report.
  static std::string GetNames(const VolumeRenderState& frame, bool isOccluded);

  /// Returns the matrix of the slices drawn into a light buffer. For a wide light, it transforms
  /// buffer coordinates, otherwise unit space.
  static glm::dmat4 GetBufferMatrix(const SlicePlan::ShadowedLight& light);

  ///@{
  /// Set the uniforms that are constant over all slabs of a sweep.
  static void SetImageUniforms(
    vtkShaderProgram* program, const VolumeRenderState& frame, std::size_t sweep);
  static void SetLightUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  static void SetReceiverUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  static void SetLayerPointUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light);
  ///@}

  /// Returns the lights evaluated by a sweep's image fragments, as indices into the image's list of
  /// lights. Lights with buffers come first, in buffer order.
  static std::vector<int> GetSweepLights(const VolumeRenderState& frame, std::size_t sweep);
};

}

#endif
