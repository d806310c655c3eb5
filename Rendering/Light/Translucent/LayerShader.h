// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LayerShader_h
#define interlume_LayerShader_h

#include <array>
#include <string>
#include <vector>

class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;

namespace interlume
{

/**
 * @class   LayerShader
 * @brief   lets VTK's mappers draw their translucent geometry layer by layer
 *
 * This class adds a test to the end of VTK's fragment shaders, after clipping, textures and all
 * other code that determines a fragment's color and opacity. All steps use the same program, so
 * that a fragment has the same depth in each step.
 */
class LayerShader
{
public:
  enum Steps
  {
    /// Draw unchanged.
    SHOW,
    /// Discard translucent geometry.
    HIDE,
    /// Write the depth of all fragments, or of the fragments behind a layer.
    FIRST,
    NEXT,
    /// Write the color of fragments in a layer, or in a layer and behind it.
    SHADE,
    SHADE_REST,
    /// Write 1 - opacity of fragments in a layer, or in a layer and behind it.
    WEAKEN,
    WEAKEN_REST
  };

  /// Switches the test on or off. Returns true if that changes the shaders.
  bool Enable(bool isOn);
  bool IsOn() const { return this->On; }

  /// Returns true if a prop's shaders support the test.
  static bool CanDraw(vtkProp* prop);

  /// Mark inserts markers before VTK replaces its tags. Replace then replaces the markers with GLSL
  /// code.
  static void Mark(std::string& fragmentShader);
  void Replace(std::string& fragmentShader) const;

  /// Sets the step of the following draws, and its layer, whose texture must be active.
  void Begin(Steps step, vtkTextureObject* layer = nullptr);
  bool IsShading() const { return this->Step == SHADE || this->Step == SHADE_REST; }
  /// Sets the uniforms. \a placeholder must be active.
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop, vtkTextureObject* placeholder) const;

  /// Draws the translucent geometry of props with the renderer's camera, into the viewport \a part
  /// (left, bottom, width, height) of the bound framebuffer.
  static void DrawProps(
    vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part);

private:
  bool On = false;
  Steps Step = SHOW;
  vtkTextureObject* Layer = nullptr;
};

}

#endif
