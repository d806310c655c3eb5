// SPDX-License-Identifier: BSD-3-Clause
// The warning about a large output, by number of tetrahedra or by a fraction of the memory.
#include "Output/SizeWarning.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"

#include "vtkCommand.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkTestErrorObserver.h"

#include <string>

namespace
{

using namespace reference;
using interlume::SizeWarning;

/// Returns the warning about a size, without its prefix.
std::string Warn(vtkIdType limit, double memory, double tetrahedra, double bytes)
{
  vtkNew<vtkIntervalVolume> owner;
  vtkNew<vtkTest::ErrorObserver> observer;
  owner->AddObserver(vtkCommand::WarningEvent, observer);
  SizeWarning warning(owner, limit, memory);
  SizeWarning::Size size;
  size.Tetrahedra = tetrahedra;
  size.Bytes = bytes;
  size.Advice = "Do less.";
  warning.Check(size);
  const std::string text = ToSingleLine(observer->GetWarningMessage());
  observer->Clear();
  warning.Check(size);
  return observer->GetWarning() ? "repeated: " + text : text;
}

}

int TestSizeWarning(int, char*[])
{
  Check check;
  const std::string text = Warn(5000000, 8e9, 6.34e6, 4.4e8);
  check.That(text ==
      "The output will have 6.3 million tetrahedra and take about 440.0 MB of 8.0 GB memory. "
      "Extraction and rendering may be slow. Do less. This warning is issued above "
      "SizeWarningLimit (5.0 million tetrahedra; 0 turns it off) or a quarter of the memory.",
    text);
  check.That(Warn(5000000, 8e9, 5e6, 2e9).empty(), "no warning at the limits");
  check.Contains(Warn(5000000, 8e9, 4e6, 2.01e9), "4.0 million tetrahedra and take about 2.0 GB");
  check.Contains(Warn(99, 8e9, 100, 1), "have 100 tetrahedra and take about 0.1 MB of 8.0 GB");
  check.Contains(Warn(5000000, 8e9, 1.26e9, 1), "1.3 billion tetrahedra");
  check.That(Warn(0, 8e9, 1e12, 1e12).empty(), "no warning without a limit");
  check.That(Warn(5000000, 0, 4e6, 1e15).empty(), "no warning about unknown memory");
  check.Contains(Warn(5000000, 0, 6e6, 1e9), "take about 1.0 GB. Extraction");
  check.That(SizeWarning::GetMachineMemory() > 1e8 && SizeWarning::GetMachineMemory() < 1e14,
    "memory of the machine: " + std::to_string(SizeWarning::GetMachineMemory()));
  return check.Result();
}
