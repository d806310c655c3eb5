// SPDX-License-Identifier: BSD-3-Clause
// Runs TetGen for vtkTetrahedralMesher. Reads problems from the socket at standard input and writes
// solutions to it until it is closed. If TetGen exits, crashes or does not terminate, only this
// program is affected.
#include "TetGen/TetGenChannel.h"

#include <tetgen.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace
{
// By default, TetGen 1.6 smooths the mesh, which moves input points (s0 turns this off), and treats
// plates thinner than 1e-8 of their length as planar (T sets the tolerance).
#ifdef INTERLUME_TETGEN_SMOOTHS
const char* const SwitchesOfVersion = "s0T1e-14";
#else
const char* const SwitchesOfVersion = "";
#endif

/// Copies a list for TetGen, which frees its input with delete[].
template <typename Value>
Value* CopyOf(const std::vector<Value>& list)
{
  Value* copy = new Value[list.size()];
  std::copy(list.begin(), list.end(), copy);
  return copy;
}

template <typename Value>
std::vector<Value> ListOf(const Value* values, int number, int components)
{
  return values ? std::vector<Value>(values, values + static_cast<std::size_t>(number) * components)
                : std::vector<Value>();
}

void AddFacets(const std::vector<int>& triangles, const std::vector<int>& markers, tetgenio& input)
{
  input.numberoffacets = static_cast<int>(markers.size());
  input.facetlist = new tetgenio::facet[input.numberoffacets];
  input.facetmarkerlist = CopyOf(markers);
  for (int i = 0; i < input.numberoffacets; ++i)
  {
    tetgenio::facet& facet = input.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    std::copy_n(&triangles[3 * i], 3, facet.polygonlist->vertexlist);
  }
}

interlume::TetGenSolution Solve(const interlume::TetGenProblem& problem)
{
  tetgenio input;
  tetgenio output;
  input.firstnumber = 0;
  input.numberofpoints = static_cast<int>(problem.Points.size() / 3);
  input.pointlist = CopyOf(problem.Points);
  if (problem.Tetrahedra.empty())
  {
    AddFacets(problem.Triangles, problem.Markers, input);
  }
  else
  {
    input.numberoftrifaces = static_cast<int>(problem.Markers.size());
    input.trifacelist = CopyOf(problem.Triangles);
    input.trifacemarkerlist = CopyOf(problem.Markers);
    input.numberoftetrahedra = static_cast<int>(problem.Tetrahedra.size() / 4);
    input.numberofcorners = 4;
    input.tetrahedronlist = CopyOf(problem.Tetrahedra);
  }
  // TetGen calls std::rand. Set the seed so that a solution does not depend on earlier problems.
  std::srand(1);
  std::string switches = problem.Switches + SwitchesOfVersion;
  tetrahedralize(&switches[0], &input, &output);

  interlume::TetGenSolution solution;
  solution.Points = ListOf(output.pointlist, output.numberofpoints, 3);
  solution.Tetrahedra = ListOf(output.tetrahedronlist, output.numberoftetrahedra, 4);
  solution.Neighbors = ListOf(output.neighborlist, output.numberoftetrahedra, 4);
  if (output.trifacemarkerlist)
  {
    solution.Triangles = ListOf(output.trifacelist, output.numberoftrifaces, 3);
    solution.Markers = ListOf(output.trifacemarkerlist, output.numberoftrifaces, 1);
  }
  return solution;
}
}

int main()
{
  // Change to a temporary directory, because TetGen 1.6 writes files to the current directory after
  // some failures.
  std::error_code ignored;
  std::filesystem::current_path(std::filesystem::temp_directory_path(ignored), ignored);
  // Flush each line so that no output is lost if TetGen crashes.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  interlume::TetGenChannel channel(STDIN_FILENO);
  interlume::TetGenProblem problem;
  while (channel.Receive(problem))
  {
    interlume::TetGenSolution solution;
    try
    {
      solution = Solve(problem);
    }
    catch (int code)
    {
      solution.Code = code;
    }
    catch (...)
    {
      solution.Code = -1;
    }
    std::fflush(stdout);
    if (!channel.Send(solution) || solution.Code != 0)
    {
      break;
    }
  }
  // Skip destructors because they may crash after TetGen has thrown.
  std::_Exit(EXIT_SUCCESS);
}
