// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConstructiveModelSource.h"

#include "vtkObjectFactory.h"
#include "vtkSpatialObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkConstructiveModelSource);

namespace
{
constexpr int MinimumResolution = 2;
constexpr int MaximumResolution = 2048;
}

vtkConstructiveModelSource::vtkConstructiveModelSource()
{
  this->SetRoot(vtkConstructiveModels::Make(this->Model));
  this->FitRoot(this->Resolution);
}

void vtkConstructiveModelSource::SetModel(int model)
{
  const int clamped = std::max(0, std::min(model, vtkConstructiveModels::NUMBER_OF_MODELS - 1));
  if (this->Model != clamped)
  {
    this->Model = clamped;
    this->SetRoot(vtkConstructiveModels::Make(clamped));
    this->FitRoot(this->Resolution);
    this->Modified();
  }
}

void vtkConstructiveModelSource::SetResolution(int resolution)
{
  const int clamped = std::max(MinimumResolution, std::min(resolution, MaximumResolution));
  if (this->Resolution != clamped)
  {
    this->Resolution = clamped;
    this->FitRoot(clamped);
    this->Modified();
  }
}

void vtkConstructiveModelSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << vtkConstructiveModels::GetModelName(this->Model) << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
