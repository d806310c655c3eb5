// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Lays a picture that is coarser than the viewport, as colour times opacity, over the scene. Each of
// its pixels ends at the surface that its middle shows, so that only those count, of the four around
// a fragment, that end about where the fragment's own surface is: else rims would be left around
// surfaces, within which the picture of what is behind them is mixed with that before them.
in vec2 texCoord;
uniform sampler2D image;
uniform vec2 imageSize;
uniform sampler2D surfaceDepth;
#ifdef FRONT
// The depth of the surfaces before which the picture shows nothing.
uniform sampler2D frontDepth;
#endif
uniform mat4 unitFromClip;
// The direction in which the eye looks.
uniform vec3 sightline;
// The difference between depths that is that of a slanted surface.
uniform float slant;

//VTK::Output::Dec

// Returns how far away a surface is, as far as volumes are in the sphere of radius 1 around 0.
float alongSight(sampler2D depths, vec2 place)
{
  float window = texture(depths, place).r;
  vec4 surface = unitFromClip * vec4(vec3(place, window) * 2.0 - 1.0, 1.0);
  return window < 1.0 ? clamp(dot(surface.xyz / surface.w, sightline), -1.0, 1.0) : 1.0;
}

vec2 endsOfPicture(vec2 place)
{
#ifdef FRONT
  return vec2(alongSight(surfaceDepth, place), alongSight(frontDepth, place));
#else
  return vec2(alongSight(surfaceDepth, place), 0.0);
#endif
}

void main()
{
  vec2 ends = endsOfPicture(texCoord);
  vec2 texel = texCoord * imageSize - 0.5;
  vec2 lower = floor(texel);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 corner = vec2(i % 2, i / 2);
    vec2 share = mix(1.0 - (texel - lower), texel - lower, corner);
    vec2 place = (clamp(lower + corner, vec2(0.0), imageSize - 1.0) + 0.5) / imageSize;
    vec2 apart = (endsOfPicture(place) - ends) / slant;
    float difference = dot(apart, apart);
    float weight = share.x * share.y / (1.0 + difference * difference);
    sum += weight * textureLod(image, place, 0.0);
    total += weight;
  }
  gl_FragData[0] = sum / total;
}
