// SPDX-License-Identifier: BSD-3-Clause
#include "pqLivePreviewDecorator.h"

#include "pqApplicationCore.h"
#include "pqPropertiesPanel.h"
#include "pqPropertyWidget.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMViewProxy.h"

#include <QEvent>
#include <QSlider>

namespace
{
pqServerManagerModel* GetModel()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

/// Updates and renders the views as after Apply.
void RenderApplied(QObject* widget)
{
  for (QObject* at = widget; at; at = at->parent())
  {
    if (auto* panel = qobject_cast<pqPropertiesPanel*>(at))
    {
      Q_EMIT panel->applied();
      return;
    }
  }
  pqApplicationCore::instance()->render();
}
}

pqLivePreviewDecorator::pqLivePreviewDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
{
  xml->GetScalarAttribute("cells", &this->Cells);
  // Runs after all mouse events that have arrived during an update.
  this->Timer.setSingleShot(true);
  this->connect(&this->Timer, SIGNAL(timeout()), SLOT(update()));
  for (QSlider* slider : parent->findChildren<QSlider*>())
  {
    this->connect(slider, SIGNAL(sliderPressed()), SLOT(begin()));
    this->connect(slider, SIGNAL(valueChanged(int)), SLOT(schedule()));
    this->connect(slider, SIGNAL(sliderReleased()), SLOT(end()));
    slider->installEventFilter(this);
  }
}

pqLivePreviewDecorator::~pqLivePreviewDecorator() = default;

pqProxy* pqLivePreviewDecorator::findProxy() const
{
  return GetModel()->findItem<pqProxy*>(this->parentWidget()->proxy());
}

bool pqLivePreviewDecorator::eventFilter(QObject* slider, QEvent* event)
{
  // A slider that is hidden while it is dragged is never released. Wait until its filter, which may
  // be the reason, is deleted.
  if (event->type() == QEvent::Hide)
  {
    QMetaObject::invokeMethod(this, "end", Qt::QueuedConnection);
  }
  return Superclass::eventFilter(slider, event);
}

void pqLivePreviewDecorator::begin()
{
  const pqProxy* proxy = this->findProxy();
  this->IsLive = proxy && proxy->modifiedState() == pqProxy::UNMODIFIED;
  this->Before = vtkSMPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  this->Sent = this->Before;
}

void pqLivePreviewDecorator::schedule()
{
  if (this->IsLive && !this->Timer.isActive())
  {
    this->Timer.start(0);
  }
}

void pqLivePreviewDecorator::push(const std::vector<double>& values, int cells)
{
  vtkSMProxy* proxy = this->parentWidget()->proxy();
  vtkSMPropertyHelper(proxy, "PreviewCellLimit").Set(cells);
  vtkSMPropertyHelper(this->parentWidget()->property())
    .Set(values.data(), static_cast<unsigned int>(values.size()));
  proxy->UpdateVTKObjects();
}

void pqLivePreviewDecorator::update()
{
  pqProxy* proxy = this->findProxy();
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  if (!proxy || !this->IsLive || values == this->Sent)
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  this->Sent = values;
  this->push(values, this->Cells);
  proxy->setModifiedState(pqProxy::UNMODIFIED);
  for (pqRenderView* view : GetModel()->findItems<pqRenderView*>())
  {
    if (view->getViewProxy()->GetNeedsUpdate())
    {
      view->getViewProxy()->InteractiveRender();
    }
  }
}

void pqLivePreviewDecorator::end()
{
  pqProxy* proxy = this->findProxy();
  const std::vector<double> values =
    vtkSMUncheckedPropertyHelper(this->parentWidget()->property()).GetDoubleArray();
  const bool isChanged =
    proxy && this->IsLive && (values != this->Before || this->Sent != this->Before);
  this->IsLive = false;
  if (!isChanged)
  {
    return;
  }
  // Undo and trace record the change from the values before the drag.
  {
    SCOPED_UNDO_EXCLUDE();
    this->push(this->Before, 0);
  }
  SCOPED_UNDO_SET(tr("Drag Slider"));
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->parentWidget()->proxy());
    this->push(values, 0);
  }
  proxy->setModifiedState(pqProxy::UNMODIFIED);
  RenderApplied(this->parentWidget());
}
