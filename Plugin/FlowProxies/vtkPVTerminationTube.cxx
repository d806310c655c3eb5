// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTerminationTube.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVTerminationTube);

vtkPVTerminationTube::vtkPVTerminationTube()
{
  this->PlacePoints();
}

void vtkPVTerminationTube::SetStart(double x, double y, double z)
{
  this->Start[0] = x;
  this->Start[1] = y;
  this->Start[2] = z;
  this->PlacePoints();
}

void vtkPVTerminationTube::SetEnd(double x, double y, double z)
{
  this->End[0] = x;
  this->End[1] = y;
  this->End[2] = z;
  this->PlacePoints();
}

void vtkPVTerminationTube::AddLinePoint(double x, double y, double z)
{
  this->LinePoints.push_back({ { x, y, z } });
  this->PlacePoints();
}

void vtkPVTerminationTube::RemoveAllLinePoints()
{
  this->LinePoints.clear();
  this->PlacePoints();
}

void vtkPVTerminationTube::PlacePoints()
{
  this->RemoveAllPoints();
  if (this->LinePoints.size() < 2)
  {
    this->AddPoint(this->Start[0], this->Start[1], this->Start[2]);
    this->AddPoint(this->End[0], this->End[1], this->End[2]);
    return;
  }
  for (const std::array<double, 3>& point : this->LinePoints)
  {
    this->AddPoint(point[0], point[1], point[2]);
  }
}

void vtkPVTerminationTube::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Start: " << this->Start[0] << " " << this->Start[1] << " " << this->Start[2]
     << "\n";
  os << indent << "End: " << this->End[0] << " " << this->End[1] << " " << this->End[2] << "\n";
  os << indent << "LinePoints: " << this->LinePoints.size() << "\n";
}
