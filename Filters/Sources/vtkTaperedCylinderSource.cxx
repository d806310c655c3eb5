// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTaperedCylinderSource.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Vortices/VortexStreet.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTaperedCylinderSource);

namespace
{
// The clustering of points towards the wall, and towards the wake.
constexpr double Clustering = 2.0;
constexpr double ClusteringAround = 0.75;
}

vtkTaperedCylinderSource::vtkTaperedCylinderSource()
  : Superclass("density", 64, 64, 32)
{
}

void vtkTaperedCylinderSource::SetRadii(double bottom, double top)
{
  interlume::ClampedValue::Set(this, this->Radii, { bottom, top }, 0.05, 50.0);
}

void vtkTaperedCylinderSource::SetHeight(double height)
{
  interlume::ClampedValue::Set(this, this->Height, height, 0.1, 1000.0);
}

void vtkTaperedCylinderSource::SetOuterRadius(double radius)
{
  interlume::ClampedValue::Set(this, this->OuterRadius, radius, 0.1, 200.0);
}

void vtkTaperedCylinderSource::SetSpeed(double speed)
{
  interlume::ClampedValue::Set(this, this->Speed, speed, 0.001, 1000.0);
}

void vtkTaperedCylinderSource::SetStrouhalNumber(double number)
{
  interlume::ClampedValue::Set(this, this->StrouhalNumber, number, 0.01, 1.0);
}

double vtkTaperedCylinderSource::GetGridRadius() const
{
  return std::max(this->OuterRadius, 2.0 * std::max(this->Radii[0], this->Radii[1]));
}

void vtkTaperedCylinderSource::GetPosition(const int ijk[3], double x[3]) const
{
  const double height = static_cast<double>(ijk[2]) / (this->GetDimension(2) - 1);
  const double wall = (1.0 - height) * this->Radii[0] + height * this->Radii[1];
  const double outward = static_cast<double>(ijk[0]) / (this->GetDimension(0) - 1);
  const double radius = wall +
    (this->GetGridRadius() - wall) * std::expm1(Clustering * outward) / std::expm1(Clustering);
  // The last point around is the first one, to the bit.
  const double around =
    static_cast<double>(ijk[1] % (this->GetDimension(1) - 1)) / (this->GetDimension(1) - 1);
  const double turn = 2.0 * vtkMath::Pi() * around;
  const double angle = turn - vtkMath::Pi() + ClusteringAround * std::sin(turn);
  x[0] = radius * std::cos(angle);
  x[1] = radius * std::sin(angle);
  x[2] = height * this->Height;
}

vtkFieldSampler::Field vtkTaperedCylinderSource::GetFieldAtTime(double t) const
{
  const interlume::VortexStreet street({ { { this->Radii[0], this->Radii[1] } }, this->Height,
                                         this->GetGridRadius(), this->Speed, this->StrouhalNumber },
    t);
  return [street](const double x[3]) { return 1.0 - street(x); };
}

void vtkTaperedCylinderSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Radii", this->Radii }, { "Height", this->Height }, { "OuterRadius", this->OuterRadius },
      { "Speed", this->Speed }, { "StrouhalNumber", this->StrouhalNumber } });
}
