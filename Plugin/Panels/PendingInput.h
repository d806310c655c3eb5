// SPDX-License-Identifier: BSD-3-Clause
#ifndef PendingInput_h
#define PendingInput_h

#include <QPoint>

/**
 * @class   PendingInput
 * @brief   detects input of the user that arrives while the client does not process events
 *
 * On X11 with Qt 5, input is any event of a key, a button, the wheel or the mouse in the client's
 * windows. Otherwise, Qt has no function for this, and only movements of the mouse are detected.
 */
class PendingInput
{
public:
  /// Starts waiting for input.
  PendingInput();
  /// Returns true if there is input.
  bool Exists() const;

private:
  QPoint Position;
};

#endif
