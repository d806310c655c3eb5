// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/CostSection.h"

#include "Benchmarks/Costs/CostRows.h"
#include "Benchmarks/Report/ReportTables.h"
#include "Benchmarks/Results/BenchMachine.h"
#include "Pages/HtmlText.h"

#include <sstream>
#include <vector>

namespace html
{
std::string CostsOf(const BenchResults& results)
{
  std::vector<BenchRow> features;
  std::vector<BenchRow> classes;
  std::vector<BenchRow> scenes;
  std::vector<BenchRow> others;
  for (const BenchRow& row : results.RowsOf(costs::Suite))
  {
    const bool isOfAll = row.Case == costs::AllScenes;
    (row.Method == costs::AllFeatures        ? scenes
        : isOfAll && row.Parameter.is_null() ? classes
        : isOfAll                            ? features
                                             : others)
      .push_back(row);
  }
  if (scenes.empty())
  {
    return {};
  }
  std::ostringstream text;
  text
    << "<p>What is left of each feature that a scene of the gallery does not use, once it was on "
       "and is off again, over what there was before: the largest of passes, buffers, bytes, "
       "words of shaders, arrays and what reports say of it (own), over "
    << scenes.size()
    << " scenes; ms is processor time of all threads by pairs of runs in turn with the same scene "
       "built again, which never had the feature: the median, within noise where it is no "
       "more than the distance of the quartiles of the pairs. With on_ what it adds while it "
       "is on, medians. "
    << Escaped(MachineInOneLine(results.Machine, results.Vtk)) << "; "
    << Escaped(ConditionsInOneLine(results.Conditions)) << "; "
    << Escaped(results.Conditions.value("command", "")) << ".</p>\n"
    << TableOf(features) << Folded(std::to_string(scenes.size()) + " scenes", TableOf(scenes))
    << Folded(std::to_string(classes.size()) +
           " classes that scenes execute; in others they have "
           "no execution, array or byte",
         TableOf(classes))
    << Folded(std::to_string(others.size()) + " rows of scenes", TableOf(others));
  return text.str();
}
}
