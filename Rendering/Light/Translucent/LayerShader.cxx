// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/LayerShader.h"

#include "InterlumeSceneLayer.h"
#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

namespace interlume
{

namespace
{
const std::string TAG = "//VTK::DepthPeeling::Impl";
const std::string DECLARATION_TAG = "//VTK::DepthPeeling::Dec";
const std::string MARK = "//INTERLUME::SceneLayer";
const std::string DECLARATION_MARK = "//INTERLUME::SceneLayerDec";

const std::string TEST = R"(
  if (sceneStep > 0)
  {
    if (isOutsideOfSceneStep())
    {
      discard;
    }
    if (sceneStep < 4)
    {
      gl_FragData[0] = vec4(gl_FragCoord.z);
    }
    else if (sceneStep > 5)
    {
      gl_FragData[0] = vec4(1.0 - gl_FragData[0].a);
    }
  }
)";
}

bool LayerShader::Enable(bool isOn)
{
  const bool isNew = isOn != this->On;
  this->On = isOn;
  this->Begin(SHOW);
  return isNew;
}

bool LayerShader::CanDraw(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor)
  {
    return true;
  }
  vtkMapper* mapper = actor->GetMapper();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return mapper && (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkGlyph3DMapper")) &&
    (!shaders->HasFragmentShaderCode() ||
      (std::string(shaders->GetFragmentShaderCode()).find(TAG) != std::string::npos &&
        std::string(shaders->GetFragmentShaderCode()).find(DECLARATION_TAG) != std::string::npos));
}

void LayerShader::Mark(std::string& fragmentShader)
{
  vtkShaderProgram::Substitute(fragmentShader, TAG, MARK + "\n" + TAG, false);
  vtkShaderProgram::Substitute(
    fragmentShader, DECLARATION_TAG, DECLARATION_MARK + "\n" + DECLARATION_TAG, false);
}

void LayerShader::Replace(std::string& fragmentShader) const
{
  vtkShaderProgram::Substitute(
    fragmentShader, DECLARATION_MARK, this->On ? InterlumeSceneLayer : "", false);
  vtkShaderProgram::Substitute(fragmentShader, MARK, this->On ? TEST : "", false);
}

void LayerShader::Begin(Steps step, vtkTextureObject* layer)
{
  this->Step = step;
  this->Layer = layer;
}

void LayerShader::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, vtkTextureObject* placeholder) const
{
  if (!program->IsUniformUsed("sceneStep"))
  {
    return;
  }
  program->SetUniformi("sceneStep",
    prop->IsRenderingTranslucentPolygonalGeometry() && CanDraw(prop) ? this->Step : SHOW);
  program->SetUniformi("sceneLayer", (this->Layer ? this->Layer : placeholder)->GetTextureUnit());
}

void LayerShader::DrawProps(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  window->GetState()->vtkglViewport(part[0], part[1], part[2], part[3]);
  window->GetState()->vtkglScissor(part[0], part[1], part[2], part[3]);
  for (vtkProp* prop : props)
  {
    prop->RenderTranslucentPolygonalGeometry(renderer);
  }
}

}
