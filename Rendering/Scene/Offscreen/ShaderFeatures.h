// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShaderFeatures_h
#define interlume_ShaderFeatures_h

#include "InterlumeSceneModule.h"

#include <string>

namespace interlume
{

/**
 * Inserts the features of a shader in its source.
 */
namespace ShaderFeatures
{
/// Returns \a source with one `#define` for each word of \a features, a name or name=value, in the
/// place of the line `//INTERLUME::FEATURES`. Functions that cut lines to the box of a volume, to
/// clipping planes (CLIPPING_PLANES, their number) and to regions (CROPPING) replace
/// `//INTERLUME::CUTS`.
INTERLUMESCENE_EXPORT std::string Insert(const std::string& source, const std::string& features);
}

}

#endif
