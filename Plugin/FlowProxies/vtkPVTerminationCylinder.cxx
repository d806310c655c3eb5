// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTerminationCylinder.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVFieldExtent.h"

vtkStandardNewMacro(vtkPVTerminationCylinder);

void vtkPVTerminationCylinder::SetCenter(double x, double y, double z)
{
  this->Center[0] = x;
  this->Center[1] = y;
  this->Center[2] = z;
  this->PlacePoints();
}

void vtkPVTerminationCylinder::SetAxis(double x, double y, double z)
{
  this->Axis[0] = x;
  this->Axis[1] = y;
  this->Axis[2] = z;
  this->PlacePoints();
}

void vtkPVTerminationCylinder::SetLength(double length)
{
  this->Length = length;
  this->PlacePoints();
}

std::string vtkPVTerminationCylinder::InitializeFromField(vtkDataSet* field, vtkDataArray*, bool)
{
  field->GetBounds(this->FieldBounds);
  this->PlacePoints();
  return {};
}

void vtkPVTerminationCylinder::PlacePoints()
{
  double axis[3] = { this->Axis[0], this->Axis[1], this->Axis[2] };
  vtkMath::Normalize(axis);
  double ends[2];
  vtkPVFieldExtent::GetEnds(this->Length, this->FieldBounds, this->Center, axis, ends);
  double point1[3];
  double point2[3];
  for (int i = 0; i < 3; ++i)
  {
    point1[i] = this->Center[i] + ends[0] * axis[i];
    point2[i] = this->Center[i] + ends[1] * axis[i];
  }
  this->SetPoint1(point1);
  this->SetPoint2(point2);
}

void vtkPVTerminationCylinder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
  os << indent << "Length: " << this->Length << "\n";
}
