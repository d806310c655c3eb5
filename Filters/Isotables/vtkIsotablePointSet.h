#ifndef vtkIsotablePointSet_h
#define vtkIsotablePointSet_h

#include <array>   // for the words
#include <cstdint> // for the words

/**
 * @class   vtkIsotablePointSet
 * @brief   a set of at most 128 small integers
 *
 * Holds which points of a hull lie on a face. Subset and intersection are what face lattices are
 * made of.
 */
class vtkIsotablePointSet
{
public:
  static constexpr int Capacity = 128;

  void Insert(int i) { this->Words[i >> 6] |= std::uint64_t(1) << (i & 63); }
  bool Contains(int i) const { return (this->Words[i >> 6] >> (i & 63)) & 1; }
  bool IsEmpty() const { return this->Words[0] == 0 && this->Words[1] == 0; }

  int Count() const
  {
    int count = 0;
    this->ForEach([&count](int) { ++count; });
    return count;
  }

  bool IsSubsetOf(const vtkIsotablePointSet& other) const
  {
    return (this->Words[0] & ~other.Words[0]) == 0 && (this->Words[1] & ~other.Words[1]) == 0;
  }

  vtkIsotablePointSet operator&(const vtkIsotablePointSet& other) const
  {
    vtkIsotablePointSet result;
    result.Words = { this->Words[0] & other.Words[0], this->Words[1] & other.Words[1] };
    return result;
  }

  bool operator==(const vtkIsotablePointSet& other) const { return this->Words == other.Words; }
  bool operator!=(const vtkIsotablePointSet& other) const { return this->Words != other.Words; }
  bool operator<(const vtkIsotablePointSet& other) const { return this->Words < other.Words; }

  /// Calls \a visit with each member in increasing order.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (int word = 0; word < 2; ++word)
    {
      int i = 64 * word;
      for (std::uint64_t bits = this->Words[word]; bits != 0; bits >>= 1, ++i)
      {
        if (bits & 1)
        {
          visit(i);
        }
      }
    }
  }

private:
  std::array<std::uint64_t, 2> Words{ { 0, 0 } };
};

#endif
