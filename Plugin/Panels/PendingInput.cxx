// SPDX-License-Identifier: BSD-3-Clause
#include "PendingInput.h"

#include <QCursor>

#ifdef INTERLUME_HAS_X11_EXTRAS
#include <QX11Info>
#include <xcb/xcb.h>

namespace
{
bool IsInput(xcb_generic_event_t* event, void*)
{
  int type = event->response_type & 0x7f;
  if (type == XCB_GE_GENERIC)
  {
    // The input extension numbers its events like the core protocol.
    type = reinterpret_cast<xcb_ge_generic_event_t*>(event)->event_type;
  }
  return type >= XCB_KEY_PRESS && type <= XCB_MOTION_NOTIFY;
}
}
#endif

PendingInput::PendingInput()
  : Position(QCursor::pos())
{
}

bool PendingInput::Exists() const
{
#ifdef INTERLUME_HAS_X11_EXTRAS
  if (QX11Info::isPlatformX11())
  {
    return QX11Info::peekEventQueue(&IsInput);
  }
#endif
  return QCursor::pos() != this->Position;
}
