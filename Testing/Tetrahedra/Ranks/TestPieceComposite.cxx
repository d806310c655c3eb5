// SPDX-License-Identifier: BSD-3-Clause
// Tests that layers of several processes, composited in any order of processes, equal the layers
// composited by one process.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "Pieces/PieceExchange.h"

#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using reference::Check;

constexpr std::size_t PIXELS = 501;

/// Returns the layer of a process, with transparent, opaque and translucent pixels.
std::vector<float> MakeLayer(int rank, unsigned int seed)
{
  std::mt19937 random(seed + 97u * static_cast<unsigned int>(rank));
  std::uniform_real_distribution<float> number(0.0f, 1.0f);
  std::vector<float> colors(4 * PIXELS);
  for (std::size_t p = 0; p < PIXELS; ++p)
  {
    const float opacity = random() % 4 == 0 ? 0.0f : random() % 8 == 0 ? 1.0f : number(random);
    for (std::size_t c = 0; c < 3; ++c)
    {
      colors[4 * p + c] = opacity * number(random);
    }
    colors[4 * p + 3] = opacity;
  }
  return colors;
}

std::vector<double> CompositeSerially(const std::vector<int>& order, unsigned int seed)
{
  std::vector<double> image(4 * PIXELS, 0.0);
  for (const int rank : order)
  {
    const std::vector<float> layer = MakeLayer(rank, seed);
    for (std::size_t p = 0; p < PIXELS; ++p)
    {
      const double transmittance = 1.0 - image[4 * p + 3];
      for (std::size_t c = 4 * p; c < 4 * p + 4; ++c)
      {
        image[c] += transmittance * static_cast<double>(layer[c]);
      }
    }
  }
  return image;
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  Check check;
  const interlume::PieceExchange exchange(controller, 0, {}, nullptr);
  std::vector<int> order(static_cast<std::size_t>(exchange.GetNumberOfRanks()));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(3);
  for (unsigned int round = 0; round < 20; ++round)
  {
    std::shuffle(order.begin(), order.end(), random);
    std::vector<float> colors = MakeLayer(exchange.GetRank(), round);
    exchange.Composite(colors, order);
    const std::vector<double> expected = CompositeSerially(order, round);
    double error = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      reference::KeepLargest(error, std::abs(static_cast<double>(colors[i]) - expected[i]));
    }
    check.Near(error, 0.0, 1e-6, "round " + std::to_string(round) + ", largest error", 1.0);
  }
  const int own = check.Result();
  int result = EXIT_SUCCESS;
  controller->AllReduce(&own, &result, 1, vtkCommunicator::MAX_OP);
  controller->Finalize();
  return result;
}
