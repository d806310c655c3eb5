// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqHyphenInSearch_h
#define pqHyphenInSearch_h

#include <QObject>

/**
 * @class   pqHyphenInSearch
 * @brief   accepts hyphens in the search box for filters (Ctrl+Space)
 *
 * The dialog ignores hyphens and would not find Time-Varying Interval Volume by its name. Here, a
 * hyphen separates words, like a space.
 */
class pqHyphenInSearch : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHyphenInSearch(QObject* parent = nullptr);
  ~pqHyphenInSearch() override;

  void startup();
  void shutdown();

  bool eventFilter(QObject* object, QEvent* event) override;

private:
  Q_DISABLE_COPY(pqHyphenInSearch)
};

#endif
