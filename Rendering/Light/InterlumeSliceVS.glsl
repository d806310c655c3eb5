//VTK::System::Dec

// A point of a slice, in unit space, as the eye or a light sees it.
in vec3 placeIn;
uniform mat4 clipFromUnit;
out vec3 place;

void main()
{
  place = placeIn;
  gl_Position = clipFromUnit * vec4(placeIn, 1.0);
}
