// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowUniforms_h
#define interlume_FlowUniforms_h

class vtkShaderProgram;

namespace interlume
{

struct FlowRenderFrame;
struct FlowRenderState;

/**
 * @class   FlowUniforms
 * @brief   sets the uniforms of the shaders that draw an implicit flow field
 */
class FlowUniforms
{
public:
  /// Sets all uniforms of ray casting, including those of SetMedium.
  static void Set(
    vtkShaderProgram* program, const FlowRenderState& scene, const FlowRenderFrame& pass);
  /// Sets the uniforms for textures and shading. Slices use only these.
  static void SetMedium(
    vtkShaderProgram* program, const FlowRenderState& scene, const FlowRenderFrame& pass);
};

}

#endif
