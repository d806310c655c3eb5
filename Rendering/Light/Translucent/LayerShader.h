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
 * @brief   modifies VTK's shaders so that mappers can draw their translucent geometry layer by
 * layer
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
    /// Write the depth of all fragments (FIRST), or only of fragments behind a layer (NEXT).
    FIRST,
    NEXT,
    /// Write the color of the fragments in a layer (SHADE), or in a layer and behind it
    /// (SHADE_REST).
    SHADE,
    SHADE_REST,
    /// Write the transmittance (1 - opacity) of the fragments in a layer (WEAKEN), or in a layer
    /// and behind it (WEAKEN_REST).
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

  /// Sets the current step. \a layer, an active texture, contains the depths of the layer that the
  /// step refers to.
  void Begin(Steps step, vtkTextureObject* layer = nullptr);
  bool IsShading() const { return this->Step == SHADE || this->Step == SHADE_REST; }
  /// Sets the uniforms. \a placeholder is an active texture, used in steps without a layer.
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
