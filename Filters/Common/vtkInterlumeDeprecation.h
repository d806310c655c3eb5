// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInterlumeDeprecation_h
#define vtkInterlumeDeprecation_h

#include "vtkDeprecation.h" // for VTK_DEPRECATION

/**
 * These macros keep the old name of a setting for one release. SetOld and GetOld forward to SetNew
 * and GetNew. For a boolean, OldOn and OldOff forward as well. Compiler and Python warnings state
 * the new name.
 */
#define interlumeDeprecatedMacro(oldName, newName, type) \
  VTK_DEPRECATION("Use Set" #newName ".")                \
  void Set##oldName(type value)                          \
  {                                                      \
    this->Set##newName(value);                           \
  }                                                      \
  VTK_DEPRECATION("Use Get" #newName ".")                \
  type Get##oldName()                                    \
  {                                                      \
    return this->Get##newName();                         \
  }

#define interlumeDeprecatedBooleanMacro(oldName, newName)     \
  interlumeDeprecatedMacro(oldName, newName, bool)            \
    VTK_DEPRECATION("Use " #newName "On.") void oldName##On() \
  {                                                           \
    this->Set##newName(true);                                 \
  }                                                           \
  VTK_DEPRECATION("Use " #newName "Off.")                     \
  void oldName##Off()                                         \
  {                                                           \
    this->Set##newName(false);                                \
  }

#endif
