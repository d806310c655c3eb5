// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/SliceFeatures.h"

#include "Offscreen/ShaderFeatures.h"

#include "InterlumeLightScreen.h"
#include "InterlumeSliceFS.h"
#include "InterlumeSliceLight.h"
#include "InterlumeSliceLightFS.h"
#include "InterlumeSliceMedium.h"
#include "InterlumeSliceReceiverFS.h"
#include "InterlumeSliceScatter.h"
#include "vtkShaderProgram.h"

#include <set>
#include <sstream>

namespace interlume
{

namespace
{
std::string Replace(std::string text, const std::string& mark, const std::string& by)
{
  vtkShaderProgram::Substitute(text, mark, by);
  return text;
}

// Returns the macro names in the table, where the names of light macros end with _0.
std::set<std::string> FindNames()
{
  std::set<std::string> names;
  for (const SliceFeatures::Choice& choice : SliceFeatures::GetTable())
  {
    std::istringstream words(choice.Macros);
    for (std::string word; words >> word;)
    {
      names.insert(word.substr(0, word.find('=')));
    }
  }
  return names;
}

bool IsKnown(const std::string& name)
{
  static const std::set<std::string> names = FindNames();
  const std::size_t end = name.find_last_not_of("0123456789") + 1;
  const bool isOfLight = end < name.size() && name[end - 1] == '_';
  return names.count(isOfLight ? name.substr(0, end) + "0" : name) > 0;
}
}

const std::vector<SliceFeatures::Choice>& SliceFeatures::GetTable()
{
  static const std::vector<Choice> table{
    // Transfer functions: columns, rows, and the component that defines opacity.
    { "columns", "COLUMNS=4096", EVERY, "", "", true },
    { "material", "ROWS=1 OPACITY_OF=r", EVERY, "", "", true },
    { "material", "ROWS=2 OPACITY_OF=r", EVERY, "", "CUSTOM_MEDIUM", true },
    { "material", "ROWS=3 OPACITY_OF=r", EVERY, "", "CUSTOM_MEDIUM", true },
    { "material", "ROWS=4 OPACITY_OF=r", EVERY, "", "CUSTOM_MEDIUM", true },
    { "material", "ROWS=1 OPACITY_OF=g", EVERY, "", "CUSTOM_MEDIUM", true },
    { "material", "ROWS=1 OPACITY_OF=a", LIGHT | RECEIVER, "", "CUSTOM_MEDIUM", true },
    { "material", "ROWS=1 OPACITY_OF=a RGB", IMAGE, "", "CUSTOM_MEDIUM", true },
    { "gradient opacity", "GRADIENT_OPACITY", EVERY, "", "CUSTOM_MEDIUM" },
    { "lists", "BENDS", EVERY, "", "CUSTOM_MEDIUM" },
    { "edges", "EDGES EDGE_POSITIONS=4095", EVERY, "", "CUSTOM_MEDIUM" },
    // The medium.
    { "medium", "CUSTOM_MEDIUM", EVERY },
    { "mask", "MASK", EVERY, "", "CUSTOM_MEDIUM" },
    { "differences", "DIFFERENCES", EVERY, "", "CUSTOM_MEDIUM MASK ROWS=2 ROWS=3 ROWS=4" },
    { "cropping", "CROPPING", EVERY },
    { "clipping", "CLIPPING_PLANES=2", EVERY },
    // The numbers give each volume and light its own program. With equal shader sources, VTK would
    // share one program, and thus its uniforms.
    { "volume", "VOLUME_NUMBER=1", EVERY },
    { "light", "LIGHT_NUMBER=1", LIGHT | RECEIVER },
    // Transmission colors.
    { "light colors", "TRANSMISSION", IMAGE, "LIT",
      "CUSTOM_MEDIUM ROWS=2 ROWS=3 ROWS=4 OPACITY_OF=a" },
    { "light colors", "TRANSMISSION", LIGHT | RECEIVER, "",
      "CUSTOM_MEDIUM ROWS=2 ROWS=3 ROWS=4 OPACITY_OF=a" },
    { "light colors", "TRANSMISSION GRAY", IMAGE, "LIT" },
    { "light colors", "TRANSMISSION GRAY", LIGHT | RECEIVER },
    // Parts of a slab that separate programs draw.
    { "part", "THIN MINIMUM_DEPTH=0.15", IMAGE, "LIT SHADOW_0",
      "CUSTOM_MEDIUM SPANS GRADIENT_OPACITY" },
    { "part", "EMPTY MINIMUM_DEPTH=0.15", IMAGE, "", "CUSTOM_MEDIUM LIT BACK_TO_FRONT" },
    { "part", "THICK SUMS MINIMUM_DEPTH=0.15", IMAGE, "LIT SHADOW_0",
      "CUSTOM_MEDIUM SPANS GRADIENT_OPACITY" },
    { "spans", "SUMS SPANS", IMAGE, "", "CUSTOM_MEDIUM GRADIENT_OPACITY" },
    { "spans", "SUMS SPANS", LIGHT, "", "CUSTOM_MEDIUM GRADIENT_OPACITY WIDE" },
    // The view.
    { "projection", "PERSPECTIVE", IMAGE },
    { "near plane", "NEAR_PLANE", IMAGE },
    { "far plane", "FAR_PLANE", IMAGE },
    { "surfaces", "OPAQUE", IMAGE },
    { "surfaces in front", "FRONT", IMAGE, "OPAQUE" },
    { "order", "BACK_TO_FRONT", IMAGE },
    // Light.
    { "lookup", "NEAREST_LOOKUP", IMAGE | RECEIVER },
    { "lights", "LIT", IMAGE },
    { "shading", "SHADE", IMAGE, "LIT" },
    { "two sides", "TWO_SIDED", IMAGE, "LIT SHADE" },
    { "scattering", "SCATTER", IMAGE, "LIT", "SHADE" },
    { "brightness", "SCATTER_BRIGHTNESS", IMAGE, "LIT SCATTER" },
    { "phase function", "PHASE_ANISOTROPY", IMAGE, "LIT SCATTER" },
    { "phase function", "PHASE_TABLE PHASE_COLUMNS=4096", IMAGE, "LIT SCATTER" },
    { "scattered light", "FIELD_MAPS=3", IMAGE, "LIT SCATTER" },
    // Lights: an image program can have several, other programs have only one.
    { "position", "POSITIONAL_0", IMAGE, "LIT" },
    { "position", "POSITIONAL_0", RECEIVER },
    { "position", "POSITIONAL", LIGHT },
    { "cone", "CONE_0", IMAGE, "LIT" },
    { "cone", "CONE_0", RECEIVER },
    { "screen", "SCREEN_0", IMAGE, "LIT" },
    { "screen", "SCREEN_0", RECEIVER },
    { "screen image", "IMAGE_0", IMAGE, "LIT SCREEN_0" },
    { "screen image", "IMAGE_0", RECEIVER, "SCREEN_0" },
    { "shadow", "SHADOW_0", IMAGE, "LIT" },
    { "shadow", "SHADOW_0", RECEIVER, "", "", true },
    { "half space", "WIDE_0", IMAGE, "LIT SHADOW_0 POSITIONAL_0" },
    { "half space", "WIDE_0", RECEIVER, "POSITIONAL_0" },
    { "half space", "WIDE", LIGHT, "POSITIONAL" },
    { "forward light", "FORWARD_MAP_0=2", IMAGE, "LIT SCATTER FIELD_MAPS=3" },
    { "surfaces' shadows", "OCCLUDER_GATHER OCCLUDERS_0 OCCLUDER_FRACTION_0=1.0", IMAGE,
      "LIT SHADOW_0" },
    // Volumes in a slab after the first one.
    { "further volume", "WITHIN", RECEIVER, "VOLUME_NUMBER=1" },
  };
  return table;
}

void SliceFeatures::Add(const std::string& name, bool isOn)
{
  if (isOn)
  {
    this->Macros += " " + name;
    this->Unknown = IsKnown(name) ? this->Unknown : name;
  }
}

void SliceFeatures::AddValue(const std::string& name, const std::string& value)
{
  this->Macros += " " + name + "=" + value;
  this->Unknown = IsKnown(name) ? this->Unknown : name;
}

std::string SliceFeatures::MakeSource(const Sources& sources) const
{
  if (!this->Unknown.empty())
  {
    return "#error " + this->Unknown + " is not in the table of SliceFeatures";
  }
  const auto has = [this](const std::string& text)
  { return this->Macros.find(" " + text) != std::string::npos; };
  std::string lights = sources.Surfaces + (has("SCREEN_") ? InterlumeLightScreen : "");
  std::string calls;
  for (std::size_t i = 0; i < sources.Lights.size(); ++i)
  {
    const std::string& translucent = sources.Lights[i];
    const std::string number = std::to_string(i);
    lights += Replace(Replace(InterlumeSliceLight, "OF_TRANSLUCENT_INDEX ",
                        translucent.empty() ? translucent : translucent + " * "),
      "INDEX", number);
    calls += "shine_" + number + "(color);\n";
  }
  calls += sources.HasFluence ? "addScattered(color);\n" : "";
  std::string source = this->Program == IMAGE ? InterlumeSliceFS
    : this->Program == LIGHT                  ? InterlumeSliceLightFS
                                              : InterlumeSliceReceiverFS;
  source = Replace(source, "//INTERLUME::MEDIUM",
    Replace(InterlumeSliceMedium, "//INTERLUME::CUSTOM_MEDIUM", sources.Medium));
  source = Replace(source, "//INTERLUME::LIGHTS", lights);
  source = Replace(source, "//INTERLUME::SHINE", calls);
  source = Replace(source, "//INTERLUME::SCATTER", has("SCATTER") ? InterlumeSliceScatter : "");
  // VTK declares each output that occurs in the source, even in a disabled feature.
  source = Replace(
    source, "//INTERLUME::BATCH", sources.HasBatches ? "gl_FragData[1] = gl_FragData[0];" : "");
  return ShaderFeatures::Insert(source, this->Macros);
}

}
