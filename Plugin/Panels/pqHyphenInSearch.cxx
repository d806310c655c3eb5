// SPDX-License-Identifier: BSD-3-Clause
#include "pqHyphenInSearch.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QWidget>

pqHyphenInSearch::pqHyphenInSearch(QObject* parent)
  : Superclass(parent)
{
}

pqHyphenInSearch::~pqHyphenInSearch() = default;

void pqHyphenInSearch::startup()
{
  QCoreApplication::instance()->installEventFilter(this);
}

void pqHyphenInSearch::shutdown()
{
  QCoreApplication::instance()->removeEventFilter(this);
}

bool pqHyphenInSearch::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Minus)
  {
    auto* widget = qobject_cast<QWidget*>(object);
    if (widget && widget->window()->inherits("pqQuickLaunchDialog"))
    {
      QKeyEvent space(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, " ");
      QCoreApplication::sendEvent(object, &space);
      return true;
    }
  }
  return Superclass::eventFilter(object, event);
}
