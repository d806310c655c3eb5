// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LevelOfDetail_h
#define interlume_LevelOfDetail_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   LevelOfDetail
 * @brief   chooses the level of detail for the available time
 *
 * Level 0 has full detail. Each further level halves either the image's width and height, at most
 * twice, or the number of tetrahedra. Choose() returns the finest level whose measured time does
 * not exceed the allocated time. A level that has not been measured is expected to take half the
 * time of the previous level. The number of tetrahedra is not reduced below MINIMUM_TETRAHEDRA.
 */
class LevelOfDetail
{
public:
  static constexpr int LEVELS = 9;
  static constexpr std::uint32_t MINIMUM_TETRAHEDRA = 20000;

  /// Clears the measured times. Call it when the mesh, the window size or the render path changes.
  void Reset() { this->Seconds.fill(0.0); }
  void AddMeasurement(int level, double seconds) { this->Seconds[level] = seconds; }

  int Choose(double allocated, std::uint32_t tetrahedra) const
  {
    double expected = this->Seconds[0];
    int level = 0;
    while (level + 1 < LEVELS && expected > allocated &&
      (GetTetrahedronStride(level + 1) == 1 ||
        tetrahedra / GetTetrahedronStride(level + 1) >= MINIMUM_TETRAHEDRA))
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
