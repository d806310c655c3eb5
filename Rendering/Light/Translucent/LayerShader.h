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
 * @brief   makes VTK's mappers draw their translucent geometry layer by layer
 *
 * A fragment shader of VTK's gets one more test at its end, after clipping, textures and whatever
 * else decides on a fragment's colour and opacity. The program is the same in all steps, so that a
 * fragment has the same depth in each.
 */
class LayerShader
{
public:
  enum Steps
  {
    /// As VTK draws it.
    SHOW,
    /// Translucent geometry is left out.
    HIDE,
    /// The depth of all, of those behind a layer.
    FIRST,
    NEXT,
    /// The colours of those in a layer, of those in it and behind.
    SHADE,
    SHADE_REST,
    /// 1 - opacity of those in a layer, of those in it and behind.
    WEAKEN,
    WEAKEN_REST
  };

  /// Switches the test on or off. Returns whether it was not.
  bool Enable(bool isOn);
  bool IsOn() const { return this->On; }

  /// Returns whether a prop's shaders have a place for the test.
  static bool CanDraw(vtkProp* prop);

  /// Marks where the sources go, in a shader without VTK's parts, and puts them in.
  static void Mark(std::string& fragmentShader);
  void Replace(std::string& fragmentShader) const;

  /// The step of what is drawn next, and its layer, whose texture is active.
  void Begin(Steps step, vtkTextureObject* layer = nullptr);
  bool IsShading() const { return this->Step == SHADE || this->Step == SHADE_REST; }
  /// Sets the uniforms; \a placeholder is active.
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop, vtkTextureObject* placeholder) const;

  /// Draws the translucent geometry of props into the part \a left, \a bottom, \a width, \a height
  /// of the framebuffer that is bound, as the renderer's camera sees it.
  static void DrawProps(
    vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part);

private:
  bool On = false;
  Steps Step = SHOW;
  vtkTextureObject* Layer = nullptr;
};

}

#endif
