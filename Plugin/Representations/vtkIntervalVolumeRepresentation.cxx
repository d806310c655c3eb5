#include "vtkIntervalVolumeRepresentation.h"

#include "vtkTimeWeightedTetrahedraMapper.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"

#include <cstring>

namespace
{
const char* const MAPPER_NAME = "Interlume";
const char* const AUTOMATIC_DELTA_T = "DeltaT";
}

vtkStandardNewMacro(vtkIntervalVolumeRepresentation);

//------------------------------------------------------------------------------
vtkIntervalVolumeRepresentation::vtkIntervalVolumeRepresentation()
{
  this->AddVolumeMapper(MAPPER_NAME, this->Mapper);
  this->vtkUnstructuredGridVolumeRepresentation::SetActiveVolumeMapper(MAPPER_NAME);
}

//------------------------------------------------------------------------------
vtkIntervalVolumeRepresentation::~vtkIntervalVolumeRepresentation() = default;

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetBlendMode(int mode)
{
  this->Mapper->SetBlendMode(mode);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetIntegrationMode(int mode)
{
  this->Mapper->SetIntegrationMode(mode);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetSortMode(int mode)
{
  this->Mapper->SetSortMode(mode);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetRenderPath(int path)
{
  this->Mapper->SetRenderPath(path);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetAutoAdjustLevelOfDetail(bool adjust)
{
  this->Mapper->SetAutoAdjustLevelOfDetail(adjust);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetLayerArrayName(const char* name)
{
  this->Mapper->SetLayerArrayName(name);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::AddLayerPriority(int layer, double priority)
{
  this->Mapper->SetLayerPriority(layer, priority);
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::RemoveAllLayerPriorities()
{
  this->Mapper->RemoveAllLayerPriorities();
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::SetDeltaTArrayName(const char* name)
{
  const bool isAutomatic = name && std::strcmp(name, AUTOMATIC_DELTA_T) == 0;
  this->Mapper->SetDeltaTArrayName(isAutomatic ? nullptr : name ? name : "");
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  vtkInformation* colors = this->GetInputArrayInformation(0);
  const char* name = colors ? colors->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!name || !*name)
  {
    this->Actor->SetMapper(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkIntervalVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
