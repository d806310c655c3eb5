// SPDX-License-Identifier: BSD-3-Clause
// Every choice in the table of SliceFeatures, and every pair of choices that may meet, is a program
// that OpenGL compiles.
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
using Words = std::set<std::string>;

Words Split(const std::string& text)
{
  Words words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;)
  {
    words.insert(word);
  }
  return words;
}

std::string GetName(const std::string& word)
{
  return word.substr(0, word.find('='));
}

/// Returns whether a macro is among the words, with the value that \a macro has or, without one,
/// with any.
bool Has(const Words& words, const std::string& macro)
{
  return std::any_of(words.begin(), words.end(),
    [&macro](const std::string& word) { return word == macro || GetName(word) == macro; });
}

bool HasAll(const Words& words, const Choice& choice)
{
  const Words own = Split(choice.Macros);
  return std::includes(words.begin(), words.end(), own.begin(), own.end());
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

/// Returns the macros of a program with two choices, which may be the same one; none if these
/// cannot meet.
Words Combine(const std::vector<Choice>& choices, const Choice& first, const Choice& second)
{
  if (std::string(first.Aspect) == second.Aspect && std::string(first.Macros) != second.Macros)
  {
    return {};
  }
  Words words;
  Words aspects;
  for (const Choice* choice : { &first, &second })
  {
    aspects.insert(choice->Aspect);
    words.merge(Split(choice->Macros));
    words.merge(Split(choice->Needs));
  }
  for (const Choice& choice : choices)
  {
    if (choice.IsRequired && aspects.insert(choice.Aspect).second)
    {
      words.merge(Split(choice.Macros));
    }
  }
  const auto isMade = [&](const Choice& choice)
  {
    // Of choices for one aspect of which one has the macros of another and more, the former.
    return HasAll(words, choice) &&
      std::none_of(choices.begin(), choices.end(),
        [&](const Choice& other)
        {
          return std::string(other.Aspect) == choice.Aspect && HasAll(words, other) &&
            Split(other.Macros).size() > Split(choice.Macros).size();
        });
  };
  const bool isValid = std::none_of(choices.begin(), choices.end(),
    [&](const Choice& choice)
    {
      const Words excluded = Split(choice.Excludes);
      return isMade(choice) &&
        std::any_of(excluded.begin(), excluded.end(),
          [&words](const std::string& macro) { return Has(words, macro); });
    });
  return isValid ? words : Words();
}

std::string MakeSource(SliceFeatures::Programs program, const Words& words)
{
  SliceFeatures features(program);
  for (const std::string& word : words)
  {
    const std::string name = GetName(word);
    if (name == word)
    {
      features.Add(name);
    }
    else
    {
      features.AddValue(name, word.substr(name.size() + 1));
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
  const bool hasLight = program == SliceFeatures::RECEIVER || Has(words, "LIT");
  sources.Lights.resize(hasLight && program != SliceFeatures::LIGHT ? 1 : 0);
  sources.HasFluence = Has(words, "FIELD_MAPS");
  return features.MakeSource(sources);
}

void TestProgram(SliceFeatures::Programs program, const std::string& name, std::size_t least,
  vtkOpenGLRenderWindow* window, Check& check)
{
  const std::vector<Choice> choices = GetChoices(program);
  std::set<Words> combinations;
  Words met;
  for (const Choice& first : choices)
  {
    for (const Choice& second : choices)
    {
      combinations.insert(Combine(choices, first, second));
    }
  }
  combinations.erase(Words());
  vtkNew<vtkOpenGLBufferObject> vertices;
  vertices->Upload(std::vector<float>(9, 0.5F), vtkOpenGLBufferObject::ArrayBuffer);
  interlume::SlicePass pass;
  for (const Words& words : combinations)
  {
    std::string text = name + ":";
    for (const std::string& word : words)
    {
      text += " " + word;
    }
    met.insert(words.begin(), words.end());
    const interlume::Error error = pass.Prepare(window, MakeSource(program, words), vertices);
    check.That(!error, text + ": " + error.GetMessage());
  }
  for (const Choice& choice : choices)
  {
    check.That(HasAll(met, choice), name + ": a program has " + choice.Macros);
  }
  check.That(combinations.size() >= least,
    name + ": " + std::to_string(combinations.size()) + " programs are at least " +
      std::to_string(least));
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
  check.That(unknown.MakeSource({}).find("#error SHADOWS") == 0, "a macro outside of the table");
  return check.Result();
}
