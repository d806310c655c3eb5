// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzFiles.h"

#include <algorithm>
#include <map>

namespace fuzz
{

namespace
{

std::size_t PickPosition(FuzzRandom& random, const std::string& bytes)
{
  // Half of the positions are in the first 2000 bytes, which include the header with its text.
  const int size =
    static_cast<int>(random.Chance(0.5) ? std::min<std::size_t>(bytes.size(), 2000) : bytes.size());
  return static_cast<std::size_t>(random.Integer(0, std::max(size - 1, 0)));
}

/// Truncates the bytes, flips a bit, erases, inserts or zeroes a block, or changes a digit.
void Damage(FuzzRandom& random, std::string& bytes)
{
  const std::size_t position = PickPosition(random, bytes);
  switch (random.Integer(0, 5))
  {
    case 0:
      bytes.resize(position);
      break;
    case 1:
      bytes[position] = static_cast<char>(bytes[position] ^ (1 << random.Integer(0, 7)));
      break;
    case 2:
      bytes.erase(position, static_cast<std::size_t>(random.Integer(1, 40)));
      break;
    case 3:
      bytes.insert(position, bytes.substr(PickPosition(random, bytes), 40));
      break;
    case 4:
      // Changes a digit of a number, such as a size.
      for (std::size_t i = position; i < bytes.size(); ++i)
      {
        if (bytes[i] >= '0' && bytes[i] <= '9')
        {
          bytes[i] = static_cast<char>('0' + random.Integer(0, 9));
          break;
        }
      }
      break;
    default:
      std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(position),
        bytes.begin() + static_cast<std::ptrdiff_t>(std::min(position + 16, bytes.size())), '\0');
  }
}

}

void RunFiles(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FileKind kind = random.Pick(GetFileKinds());
  static std::map<std::string, std::string> intact;
  if (intact.count(kind.Name) == 0)
  {
    intact[kind.Name] = kind.MakeBytes();
    check.That(
      intact[kind.Name].size() > 1000, "the intact " + kind.Name + " has more than 1000 bytes");
  }
  std::string bytes = intact[kind.Name];
  const int times = random.Integer(0, 3);
  for (int i = 0; i < times && !bytes.empty(); ++i)
  {
    Damage(random, bytes);
  }
  text = kind.Name + ", damaged " + std::to_string(times) + " times, " +
    std::to_string(bytes.size()) + " bytes";
  const std::string error = kind.Try(bytes);
  check.That(error.empty(), error);
}

}
