// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqSourceCells_h
#define pqSourceCells_h

#include <QObject>
#include <QPointer>

#include <vtkSmartPointer.h>

class pqOutputPort;
class vtkSMSourceProxy;

/**
 * @class   pqSourceCells
 * @brief   selects the cells of the input from which selected cells of Interval Volume were made
 *
 * When cells of an Interval Volume are selected, the cells in their array OriginCell are selected
 * in its input. If the output has no such array, the status bar tells how to turn it on.
 */
class pqSourceCells : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqSourceCells(QObject* parent = nullptr);
  ~pqSourceCells() override;

  void startup();
  void shutdown();

private Q_SLOTS:
  /// Updates the selection in the input of the filter whose selection changed.
  void update(pqOutputPort* port);

private:
  Q_DISABLE_COPY(pqSourceCells)

  void clear();
  /// Returns a selection of the source cells of the cells that are selected in \a port, or null.
  static vtkSmartPointer<vtkSMSourceProxy> makeSelection(pqOutputPort* port);

  /// Output in which source cells are selected.
  QPointer<pqOutputPort> Source;
  /// Whether update() is running, which changes selections itself.
  bool IsUpdating = false;
};

#endif
