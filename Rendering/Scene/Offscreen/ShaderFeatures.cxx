// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeRayCuts.h"

#include <algorithm>
#include <sstream>

namespace interlume
{

namespace
{
void Replace(std::string& text, const std::string& mark, const std::string& by)
{
  const std::size_t position = text.find(mark);
  if (position != std::string::npos)
  {
    text.replace(position, mark.size(), by);
  }
}
}

std::string ShaderFeatures::Insert(const std::string& source, const std::string& features)
{
  std::string defines;
  std::istringstream words(features);
  for (std::string word; words >> word;)
  {
    std::replace(word.begin(), word.end(), '=', ' ');
    defines += "#define " + word + "\n";
  }
  std::string result = source;
  Replace(result, "//INTERLUME::FEATURES", defines);
  Replace(result, "//INTERLUME::CUTS", InterlumeRayCuts);
  return result;
}

}
