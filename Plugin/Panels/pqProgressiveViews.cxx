// SPDX-License-Identifier: BSD-3-Clause
#include "pqProgressiveViews.h"

#include "vtkProgressiveVolumes.h"

#include "pqAnimationManager.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPVApplicationCore.h"
#include "pqProgressManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <QApplication>
#include <QCursor>

namespace
{
/// Time, in milliseconds, that the mouse must rest after it has aborted an image.
constexpr int RESTING_TIME = 300;
/// An image is final after fewer refinements. A volume outside the view is never drawn, and its
/// image therefore never final.
constexpr int MAXIMUM_REFINEMENTS = 4;

vtkSMRenderViewProxy* GetProxy(pqView* view)
{
  return view ? vtkSMRenderViewProxy::SafeDownCast(view->getViewProxy()) : nullptr;
}

bool IsAnimationPlaying()
{
  auto* application = pqPVApplicationCore::instance();
  return application && application->animationManager() &&
    application->animationManager()->animationPlaying();
}
}

pqProgressiveViews::pqProgressiveViews(QObject* parent)
  : Superclass(parent)
{
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, &pqProgressiveViews::refine);
}

pqProgressiveViews::~pqProgressiveViews() = default;

void pqProgressiveViews::startup()
{
  QObject::connect(pqApplicationCore::instance()->getProgressManager(), &pqProgressManager::abort,
    this, &pqProgressiveViews::stop);
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &pqProgressiveViews::addView);
  for (pqView* view : model->findItems<pqView*>())
  {
    this->addView(view);
  }
}

void pqProgressiveViews::shutdown()
{
  this->Timer.stop();
}

void pqProgressiveViews::stop()
{
  this->Timer.stop();
  pqApplicationCore::instance()->getProgressManager()->setEnableAbort(false);
}

void pqProgressiveViews::addView(pqView* view)
{
  vtkSMRenderViewProxy* proxy = GetProxy(view);
  if (!proxy || view->getServer()->isRemote())
  {
    return;
  }
  this->Views.append(view);
  pqCoreUtilities::connect(
    proxy->GetRenderer(), vtkCommand::StartEvent, this, SLOT(beginImage(vtkObject*)));
  pqCoreUtilities::connect(
    proxy->GetRenderWindow(), vtkCommand::AbortCheckEvent, this, SLOT(checkAbort(vtkObject*)));
  pqCoreUtilities::connect(proxy, vtkCommand::EndEvent, this, SLOT(scheduleRefinement()));
}

void pqProgressiveViews::beginImage(vtkObject* renderer)
{
  auto* seen = vtkRenderer::SafeDownCast(renderer);
  // ParaView turns off SwapBuffers while it captures screenshots.
  vtkProgressiveVolumes::Set(
    seen, seen->GetRenderWindow()->GetSwapBuffers() != 0 && !IsAnimationPlaying());
  this->MousePosition = QCursor::pos();
}

void pqProgressiveViews::checkAbort(vtkObject* window)
{
  auto* seen = vtkRenderWindow::SafeDownCast(window);
  if (seen->GetSwapBuffers() != 0 && !IsAnimationPlaying() && QCursor::pos() != this->MousePosition)
  {
    seen->SetAbortRender(1);
    this->Refinements = 0;
    this->Timer.start(RESTING_TIME);
  }
}

void pqProgressiveViews::scheduleRefinement()
{
  this->Refinements = this->IsRefining ? this->Refinements : 0;
  if (!this->Timer.isActive())
  {
    this->Timer.start(0);
  }
}

void pqProgressiveViews::refine()
{
  const QPoint position = QCursor::pos();
  const bool isMoving =
    position != this->MousePosition || QApplication::mouseButtons() != Qt::NoButton;
  this->MousePosition = position;
  if (++this->Refinements > MAXIMUM_REFINEMENTS)
  {
    this->stop();
    return;
  }
  for (const QPointer<pqView>& view : this->Views)
  {
    vtkSMRenderViewProxy* proxy = GetProxy(view);
    if (!proxy || !vtkProgressiveVolumes::IsPending(proxy->GetRenderer()))
    {
      continue;
    }
    pqApplicationCore::instance()->getProgressManager()->setEnableAbort(true);
    if (isMoving)
    {
      this->Refinements = 0;
      this->Timer.start(RESTING_TIME);
      return;
    }
    this->IsRefining = true;
    view->forceRender();
    this->IsRefining = false;
  }
  if (!this->Timer.isActive())
  {
    this->stop();
  }
}
