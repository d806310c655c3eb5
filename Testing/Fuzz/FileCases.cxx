// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzFiles.h"

#include <algorithm>
#include <map>

namespace fuzz
{

namespace
{

std::size_t PickPlace(FuzzRandom& random, const std::string& bytes)
{
  // Half of the places are in the head, where the words are.
  const int most =
    static_cast<int>(random.Chance(0.5) ? std::min<std::size_t>(bytes.size(), 2000) : bytes.size());
  return static_cast<std::size_t>(random.Whole(0, std::max(most - 1, 0)));
}

/// Changes bytes, a word or a length.
void Damage(FuzzRandom& random, std::string& bytes)
{
  const std::size_t place = PickPlace(random, bytes);
  switch (random.Whole(0, 5))
  {
    case 0:
      bytes.resize(place);
      break;
    case 1:
      bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.Whole(0, 7)));
      break;
    case 2:
      bytes.erase(place, static_cast<std::size_t>(random.Whole(1, 40)));
      break;
    case 3:
      bytes.insert(place, bytes.substr(PickPlace(random, bytes), 40));
      break;
    case 4:
      // A digit of a number, such as a size.
      for (std::size_t i = place; i < bytes.size(); ++i)
      {
        if (bytes[i] >= '0' && bytes[i] <= '9')
        {
          bytes[i] = static_cast<char>('0' + random.Whole(0, 9));
          break;
        }
      }
      break;
    default:
      std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(place),
        bytes.begin() + static_cast<std::ptrdiff_t>(std::min(place + 16, bytes.size())), '\0');
  }
}

}

void RunFiles(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FileKind kind = random.Pick(GetFileKinds());
  static std::map<std::string, std::string> made;
  if (made.count(kind.Name) == 0)
  {
    made[kind.Name] = kind.MakeBytes();
    check.That(made[kind.Name].size() > 1000, "there is a " + kind.Name);
  }
  std::string bytes = made[kind.Name];
  const int times = random.Whole(0, 3);
  for (int i = 0; i < times && !bytes.empty(); ++i)
  {
    Damage(random, bytes);
  }
  text = kind.Name + ", damaged " + std::to_string(times) + " times, " +
    std::to_string(bytes.size()) + " bytes";
  const std::string fault = kind.Try(bytes);
  check.That(fault.empty(), fault);
}

}
