// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StiffnessTest_h
#define interlume_StiffnessTest_h

namespace interlume
{

/**
 * @class   StiffnessTest
 * @brief   which of an explicit and an L-stable method follows a streamline
 *
 * E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", section IV.2: an explicit
 * step that stability limits has h |lambda| close to the edge of its region of stability, 3.3 for
 * Dormand and Prince's method. Fifteen such steps, with fewer than six others in a row between, are
 * stiffness. It is over after six steps in a row whose h |J| is so small that the explicit method
 * could take them.
 *
 * Counts go on from cell to cell.
 */
class StiffnessTest
{
public:
  bool IsStiff() const { return this->Stiff; }

  /// Notes an accepted step of either method.
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

  /// Notes several steps of which none had a value above LeastStiff.
  void AddHarmless(int steps)
  {
    this->Count = this->Others < PatienceForOthers && this->Others + steps >= PatienceForOthers
      ? 0
      : this->Count;
    this->Others += steps;
  }

  /// Steps of values up to this are not stiff.
  static constexpr double LeastStiff = 3.25;

private:
  static constexpr double Large = LeastStiff;
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
