// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqSourceCells_h
#define pqSourceCells_h

#include <QActionGroup>

/**
 * @class   pqSourceCells
 * @brief   the menu entry Edit, Select Source Cells
 *
 * Replaces a selection of cells in the output of a filter with the property GenerateOriginArrays by
 * the cells of its input that the array OriginCell lists. If the input is hidden in the active
 * view, its outline is shown, because ParaView highlights selected cells only in visible data. If
 * the selection has no such array, a message names the setting.
 */
class pqSourceCells : public QActionGroup
{
  Q_OBJECT
  typedef QActionGroup Superclass;

public:
  explicit pqSourceCells(QObject* parent);
  ~pqSourceCells() override;

private Q_SLOTS:
  void select();

private:
  Q_DISABLE_COPY(pqSourceCells)
};

#endif
