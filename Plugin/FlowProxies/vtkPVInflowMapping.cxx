// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVInflowMapping.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkPVInflowMapping);

namespace
{
constexpr int ImagePort = 1;
}

vtkPVInflowMapping::vtkPVInflowMapping()
{
  this->SetNumberOfInputPorts(ImagePort + 1);
}

vtkPVInflowMapping::~vtkPVInflowMapping() = default;

void vtkPVInflowMapping::SetCommonFormula(const char* formula)
{
  this->CommonFormula = formula ? formula : "";
  this->Modified();
}

void vtkPVInflowMapping::AddFormula(int id, const char* formula)
{
  this->Formulas[id] = formula ? formula : "";
  this->Modified();
}

void vtkPVInflowMapping::RemoveAllFormulas()
{
  this->Formulas.clear();
  this->Modified();
}

void vtkPVInflowMapping::AddRingOf(
  int id, double centerU, double centerV, double radius, double width, double amplitude)
{
  this->Rings.push_back({ id, { centerU, centerV }, radius, width, amplitude });
  this->Modified();
}

void vtkPVInflowMapping::RemoveAllRings()
{
  this->Rings.clear();
  this->Modified();
}

int vtkPVInflowMapping::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != ImagePort)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkPVInflowMapping::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (inputs[ImagePort]->GetNumberOfInformationObjects() > 0)
  {
    // Request the whole image, since a sample may depend on any of its points.
    vtkInformation* image = inputs[ImagePort]->GetInformationObject(0);
    if (image->Has(Pipeline::WHOLE_EXTENT()))
    {
      image->Set(Pipeline::UPDATE_EXTENT(), image->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
    image->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    image->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    image->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

int vtkPVInflowMapping::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->RemoveAllMappings();
  if (!this->CommonFormula.empty())
  {
    this->SetFormula(ALL, this->CommonFormula.c_str());
  }
  for (const auto& formula : this->Formulas)
  {
    this->SetFormula(formula.first, formula.second.c_str());
  }
  for (const Ring& ring : this->Rings)
  {
    this->AddRing(ring.Id, ring.Center[0], ring.Center[1], ring.Radius, ring.Width, ring.Amplitude);
  }
  if (vtkImageData* image = vtkImageData::GetData(inputs[ImagePort]))
  {
    this->SetImage(this->ImageId, image);
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkPVInflowMapping::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CommonFormula: " << this->CommonFormula << "\n";
  for (const auto& formula : this->Formulas)
  {
    os << indent << "Formula of " << formula.first << ": " << formula.second << "\n";
  }
  os << indent << "Rings: " << this->Rings.size() << "\n";
  os << indent << "ImageId: " << this->ImageId << "\n";
}
