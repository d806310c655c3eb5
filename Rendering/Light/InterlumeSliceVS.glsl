// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// A point of a slice, in unit space, as the eye or a light sees it, or a place in a wide light's buffer.
in vec3 placeIn;
uniform mat4 clipFromUnit;
out vec3 place;
#ifdef MARKED
// The depth of the whole slice in clip coordinates, nearer from slice to slice.
uniform float sliceDepth;
#endif

void main()
{
  place = placeIn;
  gl_Position = clipFromUnit * vec4(placeIn, 1.0);
#ifdef MARKED
  gl_Position.z = sliceDepth * gl_Position.w;
#endif
}
