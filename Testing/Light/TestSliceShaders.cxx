// SPDX-License-Identifier: BSD-3-Clause
// Each choice in the table of SliceFeatures, and each valid pair of choices, yields a program that
// OpenGL compiles.
#include "Buffers/SlicePass.h"
#include "Shaders/SliceFeatures.h"

#include "Support/Checks/ReferenceCheck.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using interlume::SliceFeatures;
using reference::Check;
using Choice = SliceFeatures::Choice;
using Macros = std::set<std::string>;

Macros Split(const std::string& text)
{
  Macros macros;
  std::istringstream stream(text);
  for (std::string macro; stream >> macro;)
  {
    macros.insert(macro);
  }
  return macros;
}

std::string GetName(const std::string& macro)
{
  return macro.substr(0, macro.find('='));
}

/// Returns true if the set contains a macro, with its value if given, otherwise with any value.
bool Has(const Macros& macros, const std::string& name)
{
  return std::any_of(macros.begin(), macros.end(),
    [&name](const std::string& macro) { return macro == name || GetName(macro) == name; });
}

bool HasAll(const Macros& macros, const Choice& choice)
{
  const Macros chosen = Split(choice.Macros);
  return std::includes(macros.begin(), macros.end(), chosen.begin(), chosen.end());
}

std::vector<Choice> GetChoices(SliceFeatures::Programs program)
{
  std::vector<Choice> choices;
  for (const Choice& choice : SliceFeatures::GetTable())
  {
    if ((choice.Programs & program) != 0)
    {
      choices.push_back(choice);
    }
  }
  return choices;
}

/// Returns the macros of a program with two choices, which may be equal, or an empty set if the
/// choices exclude each other.
Macros Combine(const std::vector<Choice>& choices, const Choice& first, const Choice& second)
{
  if (std::string(first.Aspect) == second.Aspect && std::string(first.Macros) != second.Macros)
  {
    return {};
  }
  Macros macros;
  std::set<std::string> aspects;
  for (const Choice* choice : { &first, &second })
  {
    aspects.insert(choice->Aspect);
    macros.merge(Split(choice->Macros));
    macros.merge(Split(choice->Needs));
  }
  for (const Choice& choice : choices)
  {
    if (choice.IsRequired && aspects.insert(choice.Aspect).second)
    {
      macros.merge(Split(choice.Macros));
    }
  }
  const auto isSelected = [&](const Choice& choice)
  {
    // If the macros of one choice include the macros of another choice for the same aspect, the
    // choice with more macros is selected.
    return HasAll(macros, choice) &&
      std::none_of(choices.begin(), choices.end(),
        [&](const Choice& other)
        {
          return std::string(other.Aspect) == choice.Aspect && HasAll(macros, other) &&
            Split(other.Macros).size() > Split(choice.Macros).size();
        });
  };
  const bool isValid = std::none_of(choices.begin(), choices.end(),
    [&](const Choice& choice)
    {
      const Macros excluded = Split(choice.Excludes);
      return isSelected(choice) &&
        std::any_of(excluded.begin(), excluded.end(),
          [&macros](const std::string& name) { return Has(macros, name); });
    });
  return isValid ? macros : Macros();
}

std::string MakeSource(SliceFeatures::Programs program, const Macros& macros)
{
  SliceFeatures features(program);
  for (const std::string& macro : macros)
  {
    const std::string name = GetName(macro);
    if (name == macro)
    {
      features.Add(name);
    }
    else
    {
      features.AddValue(name, macro.substr(name.size() + 1));
    }
  }
  SliceFeatures::Sources sources;
  sources.Medium = R"(
float mediumAt(vec3 p, mat3 size, out vec3 color)
{
  color = p;
  return size[0].x;
}
vec3 axisAt(vec3 p)
{
  return p;
}
vec2 reflectionOf(vec3 axis, vec3 l, vec3 eye)
{
  return vec2(dot(axis, l), dot(axis, eye));
}
)";
  const bool hasLight = program == SliceFeatures::RECEIVER || Has(macros, "LIT");
  sources.Lights.resize(hasLight && program != SliceFeatures::LIGHT ? 1 : 0);
  sources.HasFluence = Has(macros, "FIELD_MAPS");
  return features.MakeSource(sources);
}

void TestProgram(SliceFeatures::Programs program, const std::string& name, std::size_t minimum,
  vtkOpenGLRenderWindow* window, Check& check)
{
  const std::vector<Choice> choices = GetChoices(program);
  std::set<Macros> combinations;
  Macros used;
  for (const Choice& first : choices)
  {
    for (const Choice& second : choices)
    {
      combinations.insert(Combine(choices, first, second));
    }
  }
  combinations.erase(Macros());
  vtkNew<vtkOpenGLBufferObject> vertices;
  vertices->Upload(std::vector<float>(9, 0.5F), vtkOpenGLBufferObject::ArrayBuffer);
  interlume::SlicePass pass;
  for (const Macros& macros : combinations)
  {
    std::string text = name + ":";
    for (const std::string& macro : macros)
    {
      text += " " + macro;
    }
    used.insert(macros.begin(), macros.end());
    const interlume::Error error = pass.Prepare(window, MakeSource(program, macros), vertices);
    check.That(!error, text + ": " + error.GetMessage());
  }
  for (const Choice& choice : choices)
  {
    check.That(HasAll(used, choice), name + ": some program has " + choice.Macros);
  }
  check.That(combinations.size() >= minimum,
    name + ": " + std::to_string(combinations.size()) + " programs, at least " +
      std::to_string(minimum));
  pass.ReleaseGraphicsResources();
  vertices->ReleaseGraphicsResources();
}
}

int TestSliceShaders(int, char*[])
{
  Check check;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetSize(16, 16);
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  window->Render();
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  TestProgram(SliceFeatures::IMAGE, "image", 500, opengl, check);
  TestProgram(SliceFeatures::LIGHT, "light", 80, opengl, check);
  TestProgram(SliceFeatures::RECEIVER, "receiver", 120, opengl, check);
  SliceFeatures unknown(SliceFeatures::IMAGE);
  unknown.Add("SHADOWS");
  check.That(
    unknown.MakeSource({}).find("#error SHADOWS") == 0, "a macro that is not in the table");
  return check.Result();
}
