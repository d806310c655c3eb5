// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGridExchange.h"

#include "vtkDIYUtilities.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace
{
constexpr int NUMBER_OF_POINTS = 10000;

/// Suppresses the error messages of the reader: a failure of this test is not an error for the
/// user.
class WarningSilencer
{
public:
  WarningSilencer() { vtkObject::GlobalWarningDisplayOff(); }
  ~WarningSilencer() { vtkObject::SetGlobalWarningDisplay(this->Display); }
  WarningSilencer(const WarningSilencer&) = delete;
  WarningSilencer& operator=(const WarningSilencer&) = delete;

private:
  const int Display = vtkObject::GetGlobalWarningDisplay();
};

bool TryExchange()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < NUMBER_OF_POINTS; ++i)
  {
    points->InsertNextPoint(0.1 * i, 0.7 * i, 0.3 * i);
  }
  vtkNew<vtkUnstructuredGrid> sent;
  sent->SetPoints(points);
  const WarningSilencer silencer;
  diy::MemoryBuffer buffer;
  vtkDIYUtilities::Save(buffer, sent);
  buffer.reset();
  vtkDataSet* read = nullptr;
  vtkDIYUtilities::Load(buffer, read);
  const auto received = vtkSmartPointer<vtkDataSet>::Take(read);
  return received && received->GetNumberOfPoints() == NUMBER_OF_POINTS;
}
}

bool vtkGridExchange::IsPossible()
{
  static const bool isPossible = TryExchange();
  return isPossible;
}
