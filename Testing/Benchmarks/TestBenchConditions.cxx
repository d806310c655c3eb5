// SPDX-License-Identifier: BSD-3-Clause
// Conditions of runs that are put together: each keeps its command, date and load.
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
  check.That(JoinConditions({ first }) == first, "one run stays as it is");

  const auto joined = JoinConditions({ first, second });
  check.That(joined["command"] == "costs a; costs b", "the commands of all");
  check.That(joined["date"] == "2026-03-02 to 2026-03-04", "the first and the last date");
  check.That(!joined.contains("load"), "no load of one for all");
  check.That(joined["size"] == "full" && joined["threads"] == 2, "what is the same");
  check.That(joined["parts"] ==
      nlohmann::ordered_json::array(
        { MakePart("costs a", "2026-03-04", 0.5), MakePart("costs b", "2026-03-02", 1.5) }),
    "each with its date and load: " + joined.dump());
  check.That(ConditionsInOneLine(joined) ==
      "full size, up to 2 threads, 2026-03-02 to 2026-03-04, loads before 0.5 on 2026-03-04, 1.5 "
      "on "
      "2026-03-02",
    "in one line: " + ConditionsInOneLine(joined));

  const auto again = JoinConditions({ joined, third });
  check.Equal(again["parts"].size(), 3, "parts of parts are parts");
  check.That(again["command"] == "costs a; costs b; costs c", "with their commands");
  check.That(again["date"] == "2026-03-02 to 2026-03-05", "and dates");
  check.That(!again["parts"][2].contains("load"), "a load that is not known is none");
  check.That(JoinConditions({ first, first })["date"] == "2026-03-04", "one date");
  return check.Result();
}
