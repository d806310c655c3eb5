// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LevelOfDetail_h
#define interlume_LevelOfDetail_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   LevelOfDetail
 * @brief   chooses how coarse a picture is drawn in the time there is
 *
 * Level 0 is the full picture. Each further level halves the pixels along an edge, up to a quarter,
 * or, in turn with that and then alone, takes every second of the tetrahedra that were left. The
 * finest level is chosen that took no longer than there is time, or is expected not to: half of the
 * level before. At least FEWEST tetrahedra stay.
 */
class LevelOfDetail
{
public:
  static constexpr int LEVELS = 9;
  static constexpr std::uint32_t FEWEST = 20000;

  /// Forgets the times measured, for another mesh, window size or path.
  void Reset() { this->Seconds.fill(0.0); }
  void Measured(int level, double seconds) { this->Seconds[level] = seconds; }

  int Choose(double allocated, std::uint32_t tetrahedra) const
  {
    double expected = this->Seconds[0];
    int level = 0;
    while (level + 1 < LEVELS && expected > allocated &&
      (GetTetrahedronStride(level + 1) == 1 ||
        tetrahedra / GetTetrahedronStride(level + 1) >= FEWEST))
    {
      ++level;
      expected = this->Seconds[level] > 0.0 ? this->Seconds[level] : 0.5 * expected;
    }
    return level;
  }

  static int GetPixelStride(int level) { return level == 0 ? 1 : level < 3 ? 2 : 4; }
  static std::uint32_t GetTetrahedronStride(int level)
  {
    return level < 2 ? 1u : level < 4 ? 2u : 1u << (level - 2);
  }

private:
  std::array<double, LEVELS> Seconds{};
};

}

#endif
