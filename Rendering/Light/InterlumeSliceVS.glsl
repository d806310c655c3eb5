// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Point of a slice in unit space, drawn as seen from the camera or a light, or position in the
// buffer of a light inside or near the volume.
in vec3 positionIn;
uniform mat4 clipFromUnit;
out vec3 place;
#ifdef MARKED
// Depth of the slice in clip coordinates, which decreases from slice to slice.
uniform float sliceDepth;
#endif

void main()
{
  place = positionIn;
  gl_Position = clipFromUnit * vec4(positionIn, 1.0);
#ifdef MARKED
  gl_Position.z = sliceDepth * gl_Position.w;
#endif
}
