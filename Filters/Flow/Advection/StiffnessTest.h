// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StiffnessTest_h
#define interlume_StiffnessTest_h

namespace interlume
{

/**
 * @class   StiffnessTest
 * @brief   switches a streamline between an explicit and an L-stable method
 *
 * See E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", section IV.2. If
 * stability limits an explicit step, h |lambda| is close to the boundary of the stability region,
 * 3.3 for the Dormand-Prince method. After fifteen such steps, with fewer than six other steps in a
 * row between them, the streamline is stiff. It stops being stiff after six consecutive steps whose
 * h |J| is small enough for the explicit method.
 *
 * The counters persist from cell to cell.
 */
class StiffnessTest
{
public:
  bool IsStiff() const { return this->Stiff; }

  /// Records an accepted step of the current method.
  void Add(double stiffness)
  {
    if (this->Stiff ? stiffness < Small : stiffness > Large)
    {
      this->Others = 0;
      ++this->Count;
    }
    else if (this->Stiff || ++this->Others == PatienceForOthers)
    {
      this->Count = 0;
    }
    if (this->Count == (this->Stiff ? StepsToReturn : StepsToChange))
    {
      this->Stiff = !this->Stiff;
      this->Count = 0;
      this->Others = 0;
    }
  }

  /// Records several steps whose stiffness is at most MinimumStiff.
  void AddNonStiff(int steps)
  {
    this->Count = this->Others < PatienceForOthers && this->Others + steps >= PatienceForOthers
      ? 0
      : this->Count;
    this->Others += steps;
  }

  /// Steps with a stiffness up to this value do not count as stiff.
  static constexpr double MinimumStiff = 3.25;

private:
  static constexpr double Large = MinimumStiff;
  static constexpr double Small = 2.0;
  static constexpr int StepsToChange = 15;
  static constexpr int StepsToReturn = 6;
  static constexpr int PatienceForOthers = 6;

  bool Stiff = false;
  int Count = 0;
  int Others = 0;
};

}

#endif
