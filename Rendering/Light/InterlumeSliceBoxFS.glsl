// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Box filter of the given width along one axis. If the width is even, both end texels count half.
in vec2 texCoord;
uniform sampler2D map;
uniform ivec2 axis;
uniform int width;

//VTK::Output::Dec

void main()
{
  ivec2 last = textureSize(map, 0) - 1;
  ivec2 place = ivec2(texCoord * vec2(last + 1));
  int reach = width / 2;
  float end = width % 2 == 0 ? 0.5 : 1.0;
  vec4 sum = vec4(0.0);
  for (int i = -reach; i <= reach; ++i)
  {
    float weight = abs(i) == reach ? end : 1.0;
    sum += weight * texelFetch(map, clamp(place + i * axis, ivec2(0), last), 0);
  }
  gl_FragData[0] = sum / float(width);
}
