// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringSolver.h"

namespace interlume
{

std::string ScatteringSolver::Solve(const ScatteringMedium& medium,
  const std::vector<ScatteringLight>& lights, ScatteringMode mode,
  const ScatteringSettings& settings, ScatteringField& field, ScatteringReport& report)
{
  field = ScatteringField();
  report = ScatteringReport();
  std::string wrong = medium.Check();
  const std::size_t cells = wrong.empty() ? medium.GetNumberOfCells() : 0;
  for (const ScatteringLight& light : lights)
  {
    wrong = wrong.empty() ? light.Check(cells) : wrong;
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  field.Fluence.assign(cells, glm::vec3(0.0f));
  field.Lean.assign(cells, glm::vec3(0.0f));
  (void)mode;
  (void)settings;
  return {};
}

}
