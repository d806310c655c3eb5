#include "vtkPVTerminationRectangle.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVTerminationRectangle);

//------------------------------------------------------------------------------
void vtkPVTerminationRectangle::SetCenter(double x, double y, double z)
{
  this->Center[0] = x;
  this->Center[1] = y;
  this->Center[2] = z;
  this->PlaceCorners();
}

//------------------------------------------------------------------------------
void vtkPVTerminationRectangle::SetNormal(double x, double y, double z)
{
  this->Normal[0] = x;
  this->Normal[1] = y;
  this->Normal[2] = z;
  this->PlaceCorners();
}

//------------------------------------------------------------------------------
void vtkPVTerminationRectangle::SetLengths(double u, double v)
{
  this->Lengths[0] = u;
  this->Lengths[1] = v;
  this->PlaceCorners();
}

//------------------------------------------------------------------------------
void vtkPVTerminationRectangle::SetAngle(double angle)
{
  this->Angle = angle;
  this->PlaceCorners();
}

//------------------------------------------------------------------------------
void vtkPVTerminationRectangle::PlaceCorners()
{
  // The normal is their cross product, in this order.
  double againstV[3];
  double u[3];
  vtkMath::Perpendiculars(this->Normal, againstV, u, vtkMath::RadiansFromDegrees(this->Angle));
  double origin[3];
  double point1[3];
  double point2[3];
  for (int i = 0; i < 3; ++i)
  {
    const double alongU = 0.5 * this->Lengths[0] * u[i];
    const double alongV = -0.5 * this->Lengths[1] * againstV[i];
    origin[i] = this->Center[i] - alongU - alongV;
    point1[i] = this->Center[i] + alongU - alongV;
    point2[i] = this->Center[i] - alongU + alongV;
  }
  this->SetOrigin(origin);
  this->SetPoint1(point1);
  this->SetPoint2(point2);
}

//------------------------------------------------------------------------------
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
