// SPDX-License-Identifier: BSD-3-Clause
#include "Output/SizeWarning.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace interlume
{

namespace
{
// Fraction of the memory that an output may use without a warning.
constexpr double MemoryFraction = 0.25;

// Returns the first number in a file, or 0 if there is none.
double ReadNumber(const char* name)
{
  std::ifstream file(name);
  double number = 0.0;
  return file >> number ? number : 0.0;
}

// Rounds a number to two digits, with a unit.
std::string Describe(double number, const char* million, const char* billion)
{
  std::ostringstream words;
  words.precision(1);
  words << std::fixed;
  if (number < 1e5)
  {
    words.precision(0);
    words << number;
  }
  else
  {
    words << (number < 1e9 ? number / 1e6 : number / 1e9) << (number < 1e9 ? million : billion);
  }
  return words.str();
}

std::string DescribeBytes(double bytes)
{
  return Describe(std::max(bytes, 1e5), " MB", " GB");
}
}

SizeWarning::SizeWarning(vtkAlgorithm* owner, vtkIdType limit, double memory)
  : Owner(owner)
  , Limit(static_cast<double>(limit))
  , Memory(memory)
{
}

double SizeWarning::GetMachineMemory()
{
  static const double memory = []
  {
    vtksys::SystemInformation information;
    double bytes = 1024.0 * static_cast<double>(information.GetHostMemoryTotal());
    // Containers limit the memory by control groups, of version 2 or 1.
    for (const char* name :
      { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes" })
    {
      const double limit = ReadNumber(name);
      bytes = limit > 0.0 ? std::min(bytes, limit) : bytes;
    }
    return bytes;
  }();
  return memory;
}

double SizeWarning::GetExcess(double tetrahedra, double bytes) const
{
  const double excess = this->Limit > 0.0 ? tetrahedra / this->Limit : 0.0;
  return this->Memory > 0.0 ? std::max(excess, bytes / (MemoryFraction * this->Memory)) : excess;
}

void SizeWarning::Add(
  double tetrahedra, double bytes, const std::string& advice, const std::string& cells)
{
  this->Sum.Cells = cells;
  this->Sum.Tetrahedra += tetrahedra;
  this->Sum.Bytes += bytes;
  this->Sum.Advice = advice;
  if (vtkCompositeDataSet::SafeDownCast(this->Owner->GetInputDataObject(0, 0)))
  {
    this->Sum.Qualifier = "at least ";
  }
  this->Check(this->Sum);
}

void SizeWarning::Check(const Size& size)
{
  if (!this->IsPending() || this->GetExcess(size.Tetrahedra, size.Bytes) <= 1.0)
  {
    return;
  }
  this->IsIssued = true;
  std::ostringstream words;
  words << "The output will have " << size.Qualifier
        << Describe(size.Tetrahedra, " million", " billion") << " " << size.Cells << size.Basis
        << " and take about " << DescribeBytes(size.Bytes);
  if (this->Memory > 0.0)
  {
    words << " of " << DescribeBytes(this->Memory) << " memory";
  }
  words << ". Extraction and rendering may be slow. " << size.Advice
        << " This warning is issued above SizeWarningLimit ("
        << Describe(this->Limit, " million", " billion") << " " << size.Cells
        << "; 0 turns it off) or a quarter of the memory.";
  vtkWarningWithObjectMacro(this->Owner, << words.str());
}

}
