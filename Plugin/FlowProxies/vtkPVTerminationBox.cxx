// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTerminationBox.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVTerminationBox);

void vtkPVTerminationBox::SetPosition(double x, double y, double z)
{
  this->Position[0] = x;
  this->Position[1] = y;
  this->Position[2] = z;
  this->PlaceFaces();
}

void vtkPVTerminationBox::SetLengths(double x, double y, double z)
{
  this->Lengths[0] = x;
  this->Lengths[1] = y;
  this->Lengths[2] = z;
  this->PlaceFaces();
}

void vtkPVTerminationBox::PlaceFaces()
{
  double bounds[6];
  for (int i = 0; i < 3; ++i)
  {
    bounds[2 * i] = this->Position[i];
    bounds[2 * i + 1] = this->Position[i] + this->Lengths[i];
  }
  this->SetBounds(bounds);
}

void vtkPVTerminationBox::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Position: " << this->Position[0] << " " << this->Position[1] << " "
     << this->Position[2] << "\n";
  os << indent << "Lengths: " << this->Lengths[0] << " " << this->Lengths[1] << " "
     << this->Lengths[2] << "\n";
}
