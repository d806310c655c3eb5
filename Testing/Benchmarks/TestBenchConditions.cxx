// SPDX-License-Identifier: BSD-3-Clause
// Tests that joined runs keep their commands, dates and loads.
#include "Benchmarks/Results/BenchMachine.h"
#include "Support/Checks/ReferenceCheck.h"

namespace
{
nlohmann::ordered_json MakeRun(const char* command, const char* date, double load)
{
  return { { "date", date }, { "size", "full" }, { "threads", 2 }, { "load", load },
    { "command", command } };
}

nlohmann::ordered_json MakePart(const char* command, const char* date, double load)
{
  return { { "command", command }, { "date", date }, { "load", load } };
}
}

int main()
{
  reference::Check check;
  const auto first = MakeRun("costs a", "2026-03-04", 0.5);
  const auto second = MakeRun("costs b", "2026-03-02", 1.5);
  auto third = MakeRun("costs c", "2026-03-05", 0.0);
  third.erase("load");
  check.That(JoinConditions({ first }) == first, "a single run is unchanged");

  const auto joined = JoinConditions({ first, second });
  check.That(joined["command"] == "costs a; costs b", "all commands are listed");
  check.That(joined["date"] == "2026-03-02 to 2026-03-04", "the date is a range");
  check.That(!joined.contains("load"), "loads are not merged");
  check.That(joined["size"] == "full" && joined["threads"] == 2, "equal settings remain");
  check.That(joined["parts"] ==
      nlohmann::ordered_json::array(
        { MakePart("costs a", "2026-03-04", 0.5), MakePart("costs b", "2026-03-02", 1.5) }),
    "each part has its date and load: " + joined.dump());
  check.That(ConditionsInOneLine(joined) ==
      "full size, up to 2 threads, 2026-03-02 to 2026-03-04, loads before 0.5 on 2026-03-04, 1.5 "
      "on "
      "2026-03-02",
    "text in one line: " + ConditionsInOneLine(joined));

  const auto again = JoinConditions({ joined, third });
  check.Equal(again["parts"].size(), 3, "nested parts are flattened");
  check.That(again["command"] == "costs a; costs b; costs c", "their commands are listed");
  check.That(again["date"] == "2026-03-02 to 2026-03-05", "the date range is extended");
  check.That(!again["parts"][2].contains("load"), "an unknown load is omitted");
  check.That(JoinConditions({ first, first })["date"] == "2026-03-04", "equal dates are merged");
  return check.Result();
}
