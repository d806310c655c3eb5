// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShaderFeatures_h
#define interlume_ShaderFeatures_h

#include "InterlumeSceneModule.h"

#include <string>

namespace interlume
{

/**
 * Inserts features into shader source.
 */
namespace ShaderFeatures
{
/// Returns \a source with two replacements. The line `//INTERLUME::FEATURES` becomes one `#define`
/// for each word of \a features, which is a name or name=value. The line `//INTERLUME::CUTS`
/// becomes the functions of InterlumeRayCuts.glsl. They clip rays to the box of a volume, to
/// clipping planes (CLIPPING_PLANES, their number) and to cropping regions (CROPPING).
INTERLUMESCENE_EXPORT std::string Insert(const std::string& source, const std::string& features);
}

}

#endif
