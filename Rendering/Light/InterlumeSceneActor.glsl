// SPDX-License-Identifier: BSD-3-Clause
//INTERLUME::FEATURES
// The share of each light that reaches a fragment of a surface of VTK's. The sources of VTK's own
// shaders stand before and after; places are in view coordinates.
//INTERLUME::CASTERS
uniform float sceneStrengths[SCENE_LIGHTS];
#ifdef TRANSMITTANCE
// What volumes leave of each light at the surface that each pixel shows, and that surface's depth.
uniform sampler2D sceneTransmittance;
uniform sampler2D sceneDepth;
// The first pixel of the viewport, and its size.
uniform vec4 sceneViewport;
uniform int sceneIsOpaque;

// Returns the pixel around that shows this surface: the fragment's own, but for edges with several
// samples a pixel, where that may show another one.
ivec2 scenePixel()
{
  ivec2 here = ivec2(gl_FragCoord.xy - sceneViewport.xy);
  ivec2 best = here;
  float least = abs(texelFetch(sceneDepth, here, 0).r - gl_FragCoord.z);
  if (least > 1e-6)
  {
    for (int i = 0; i < 9; ++i)
    {
      ivec2 pixel = clamp(here + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(sceneViewport.zw) - 1);
      float difference = abs(texelFetch(sceneDepth, pixel, 0).r - gl_FragCoord.z);
      best = difference < least ? pixel : best;
      least = min(difference, least);
    }
  }
  return best;
}

vec3 sceneLightOfVolumes(ivec2 pixel)
{
  return sceneIsOpaque == 1 ? texelFetch(sceneTransmittance, pixel, 0).SCENE_CHANNELS : vec3(1.0);
}
#endif

vec3 sceneLightOf(int number, vec3 share)
{
  return 1.0 - sceneStrengths[number] * (1.0 - share);
}

// Returns the plane that the triangle around the fragment lies in.
vec4 scenePlane(vec3 place)
{
  vec3 normal = cross(dFdx(place), dFdy(place));
  float size = length(normal);
  normal = size > 0.0 ? normal / size : vec3(0.0);
  return vec4(normal, -dot(normal, place));
}
