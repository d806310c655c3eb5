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
 * @brief   all that a computation depends on, as texts with names, so that a file of its results
 * can tell whether it is of the same computation
 *
 * The versions of Interlume and VTK are among them: another version may give other bytes.
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

  /// Adds the lines "name: text" of what PrintSelf or NamedValue has printed.
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

  /// Returns a stream that prints numbers to the last bit.
  static std::ostringstream MakeExactStream()
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    return text;
  }

  /// Writes the names and texts to two arrays.
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

  /// Returns what is different in the arrays that were written, by names; nothing where all is the
  /// same.
  std::string Compare(vtkFieldData* data) const
  {
    auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray(NamesArray));
    auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(TextsArray));
    std::string differences;
    for (const auto& [name, text] : this->Texts)
    {
      const vtkIdType i = names ? names->LookupValue(name) : -1;
      const bool isThere = i >= 0 && texts && i < texts->GetNumberOfValues();
      const std::string there = isThere ? texts->GetValue(i) : std::string();
      if (isThere && there == text)
      {
        continue;
      }
      // Of a digest nobody learns anything, and what objects print is long.
      constexpr std::size_t longest = 24;
      const bool isTold = isThere && there.size() <= longest && text.size() <= longest;
      differences += (differences.empty() ? "" : ", ") + name;
      differences += isTold ? " (" + there + " there, " + text + " here)" : std::string();
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
