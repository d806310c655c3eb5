
// The inflow texture of one image. This file is copied for each image.
uniform sampler2D paint_N;
uniform vec4 paintFrame_N;

vec4 inflowUpTo_N(int paint, vec2 place, float level)
{
  if (paint == NUMBER)
  {
    return textureLod(paint_N, inTexture(place, paintFrame_N), level);
  }
  return inflowUpTo_P(paint, place, level);
}
