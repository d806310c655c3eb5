// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowKind_h
#define vtkInflowKind_h

/**
 * @class   vtkInflowKind
 * @brief   kinds of mapping in vtkInflowMapping
 *
 * @sa vtkInflowMapping
 */
class vtkInflowKind
{
public:
  enum Values
  {
    NONE = 0,
    FORMULA = 1,
    RINGS = 2,
    IMAGE = 3
  };
};

#endif
