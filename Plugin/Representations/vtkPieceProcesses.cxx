// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPieceProcesses.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkRemotingCoreConfiguration.h"

#include <algorithm>
#include <vector>

namespace
{
/// Maximum overlap of two boxes along an axis that is ignored, as a fraction of the shorter edge.
/// It allows for pieces that were split in single precision.
constexpr double TOLERANCE = 1e-6;

bool AreDisjointAlong(const double* a, const double* b)
{
  const double overlap = std::min(a[1], b[1]) - std::max(a[0], b[0]);
  return overlap <= TOLERANCE * std::min(a[1] - a[0], b[1] - b[0]);
}
}

vtkMultiProcessController* vtkPieceProcesses::Find(vtkView* view, bool isReduced)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool isDistributed = renderView &&
    (isReduced ? renderView->GetUseDistributedRenderingForLODRender()
               : renderView->GetUseDistributedRenderingForRender());
  return isDistributed && controller && controller->GetNumberOfProcesses() > 1 ? controller
                                                                               : nullptr;
}

bool vtkPieceProcesses::AreDisjoint(vtkMultiProcessController* controller, const double bounds[6])
{
  std::vector<double> boxes(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(bounds, boxes.data(), 6);
  for (auto a = boxes.data(); a != boxes.data() + boxes.size(); a += 6)
  {
    for (auto b = boxes.data(); b != a; b += 6)
    {
      const bool isEmpty = a[0] > a[1] || b[0] > b[1];
      if (!isEmpty && !AreDisjointAlong(a, b) && !AreDisjointAlong(a + 2, b + 2) &&
        !AreDisjointAlong(a + 4, b + 4))
      {
        return false;
      }
    }
  }
  return true;
}

bool vtkPieceProcesses::IsAnywhere(vtkMultiProcessController* controller, bool isHere)
{
  const int local = isHere ? 1 : 0;
  int any = 0;
  controller->AllReduce(&local, &any, 1, vtkCommunicator::MAX_OP);
  return any != 0;
}

bool vtkPieceProcesses::HaveDisplays()
{
  auto* configuration = vtkRemotingCoreConfiguration::GetInstance();
  return configuration->GetIsInTileDisplay() || configuration->GetIsInCave();
}
