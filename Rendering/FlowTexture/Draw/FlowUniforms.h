// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowUniforms_h
#define interlume_FlowUniforms_h

class vtkShaderProgram;

namespace interlume
{

struct FlowPicture;
struct FlowScene;

/**
 * @class   FlowUniforms
 * @brief   tells the shader the numbers of a picture
 */
class FlowUniforms
{
public:
  /// All of lines of sight.
  static void Set(vtkShaderProgram* program, const FlowScene& scene, const FlowPicture& picture);
  /// What is painted, and how it is shaded by the matter alone.
  static void SetMedium(
    vtkShaderProgram* program, const FlowScene& scene, const FlowPicture& picture);
};

}

#endif
