// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzWatch_h
#define FuzzWatch_h

#include <chrono>             // for the time that a case takes
#include <condition_variable> // for the end
#include <mutex>              // for the case
#include <string>             // for names
#include <thread>             // for the watch

namespace fuzz
{

/**
 * @class   FuzzWatch
 * @brief   tells how far a run is, and ends it where a case does not end by itself
 *
 * A line on the error stream every ten seconds, from a thread of its own, so that a long case is
 * named while it runs. A case that takes longer than the limit ends the program, which then names
 * it and fails.
 */
class FuzzWatch
{
public:
  /// \a limit are the most seconds a case may take by the clock on the wall.
  explicit FuzzWatch(double limit);
  ~FuzzWatch();
  FuzzWatch(const FuzzWatch&) = delete;
  FuzzWatch& operator=(const FuzzWatch&) = delete;

  /// Says which case begins, as arguments of this program, and how many of its family are done.
  void Begin(const std::string& arguments, int done, int count);

  /// The case ended; until the next one begins nothing can last too long.
  void End();

private:
  using Clock = std::chrono::steady_clock;

  void Run();

  const std::chrono::duration<double> Limit;
  const Clock::time_point Start = Clock::now();
  std::mutex Mutex;
  std::condition_variable Changed;
  std::string Arguments;
  int Done = 0;
  int Count = 0;
  bool IsInCase = false;
  bool IsOver = false;
  Clock::time_point CaseStart;
  std::thread Thread;
};

}

#endif
