// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Fingerprint_h
#define interlume_Fingerprint_h

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   Fingerprint
 * @brief   the named parameters that a computation depends on
 *
 * A fingerprint is stored in a result file and compared when the file is reused. It includes the
 * versions of Interlume and VTK, since another version may produce different bytes.
 */
class Fingerprint
{
public:
  explicit Fingerprint(const std::string& version)
  {
    this->Add("version of Interlume", version);
    this->Add("version of VTK", vtkVersion::GetVTKVersion());
  }

  void Add(const std::string& name, const std::string& text)
  {
    this->Texts.emplace_back(name, text);
  }

  /// Adds the lines "name: text" printed by PrintSelf or NamedValue.
  void AddLines(const std::string& printed)
  {
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);)
    {
      const std::size_t colon = line.find(':');
      if (colon != std::string::npos)
      {
        this->Add(line.substr(0, colon), line.substr(std::min(line.size(), colon + 2)));
      }
    }
  }

  /// Returns a stream that prints doubles without loss of precision.
  static std::ostringstream MakeExactStream()
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    return text;
  }

  /// Writes the names and texts to two field arrays.
  void Write(vtkFieldData* data) const
  {
    vtkNew<vtkStringArray> names;
    names->SetName(NamesArray);
    vtkNew<vtkStringArray> texts;
    texts->SetName(TextsArray);
    for (const auto& [name, text] : this->Texts)
    {
      names->InsertNextValue(name);
      texts->InsertNextValue(text);
    }
    data->AddArray(names);
    data->AddArray(texts);
  }

  /// Compares the parameters with those stored in \a data. Returns the names of all that differ,
  /// with their values if short, or an empty string if none differs.
  std::string Compare(vtkFieldData* data) const
  {
    auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray(NamesArray));
    auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(TextsArray));
    std::string differences;
    for (const auto& [name, text] : this->Texts)
    {
      const vtkIdType i = names ? names->LookupValue(name) : -1;
      const bool isStored = i >= 0 && texts && i < texts->GetNumberOfValues();
      const std::string stored = isStored ? texts->GetValue(i) : std::string();
      if (isStored && stored == text)
      {
        continue;
      }
      // Only short values are included, since digests and printed objects are not informative.
      constexpr std::size_t maximumLength = 24;
      const bool isPrinted =
        isStored && stored.size() <= maximumLength && text.size() <= maximumLength;
      differences += (differences.empty() ? "" : ", ") + name;
      differences += isPrinted ? " (" + stored + " stored, " + text + " now)" : std::string();
    }
    return differences;
  }

private:
  static constexpr const char* NamesArray = "Fingerprint";
  static constexpr const char* TextsArray = "FingerprintValues";

  std::vector<std::pair<std::string, std::string>> Texts;
};

}

#endif
