// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShaderFeatures.h"

#include <algorithm>
#include <sstream>

std::string vtkShaderFeatures::Insert(const std::string& source, const std::string& features)
{
  static const std::string mark = "//INTERLUME::FEATURES";
  std::string defines;
  std::istringstream words(features);
  for (std::string word; words >> word;)
  {
    std::replace(word.begin(), word.end(), '=', ' ');
    defines += "#define " + word + "\n";
  }
  std::string result = source;
  const std::size_t place = result.find(mark);
  if (place != std::string::npos)
  {
    result.replace(place, mark.size(), defines);
  }
  return result;
}
