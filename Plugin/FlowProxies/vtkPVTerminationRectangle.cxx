// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTerminationRectangle.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVFieldExtent.h"

vtkStandardNewMacro(vtkPVTerminationRectangle);

void vtkPVTerminationRectangle::SetCenter(double x, double y, double z)
{
  this->Center[0] = x;
  this->Center[1] = y;
  this->Center[2] = z;
  this->PlaceCorners();
}

void vtkPVTerminationRectangle::SetNormal(double x, double y, double z)
{
  this->Normal[0] = x;
  this->Normal[1] = y;
  this->Normal[2] = z;
  this->PlaceCorners();
}

void vtkPVTerminationRectangle::SetLengths(double u, double v)
{
  this->Lengths[0] = u;
  this->Lengths[1] = v;
  this->PlaceCorners();
}

void vtkPVTerminationRectangle::SetAngle(double angle)
{
  this->Angle = angle;
  this->PlaceCorners();
}

std::string vtkPVTerminationRectangle::InitializeFromField(vtkDataSet* field, vtkDataArray*, bool)
{
  field->GetBounds(this->FieldBounds);
  this->PlaceCorners();
  return {};
}

void vtkPVTerminationRectangle::PlaceCorners()
{
  // vtkMath::Perpendiculars returns two vectors whose cross product, in this order, is the normal.
  double negativeV[3];
  double u[3];
  vtkMath::Perpendiculars(this->Normal, negativeV, u, vtkMath::RadiansFromDegrees(this->Angle));
  const double v[3] = { -negativeV[0], -negativeV[1], -negativeV[2] };
  double alongU[2];
  double alongV[2];
  vtkPVFieldExtent::GetEnds(this->Lengths[0], this->FieldBounds, this->Center, u, alongU);
  vtkPVFieldExtent::GetEnds(this->Lengths[1], this->FieldBounds, this->Center, v, alongV);
  double origin[3];
  double point1[3];
  double point2[3];
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = this->Center[i] + alongU[0] * u[i] + alongV[0] * v[i];
    point1[i] = this->Center[i] + alongU[1] * u[i] + alongV[0] * v[i];
    point2[i] = this->Center[i] + alongU[0] * u[i] + alongV[1] * v[i];
  }
  this->SetOrigin(origin);
  this->SetPoint1(point1);
  this->SetPoint2(point2);
}

void vtkPVTerminationRectangle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2]
     << "\n";
  os << indent << "Lengths: " << this->Lengths[0] << " " << this->Lengths[1] << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
}
