// SPDX-License-Identifier: BSD-3-Clause
// The matter along a ray, for fragments of the picture and of a light's buffer. ROWS functions of
// COLUMNS samples; OPACITY_OF names the components of a texel that have an opacity. With MATTER there
// are functions of their own in the place of all these: see vtkSliceMedium.

#ifdef MATTER
//INTERLUME::MATTER
#else
uniform sampler3D volume;
uniform sampler2D extinctions;
#ifdef SUMS
uniform sampler2D extinctionSums;
#endif
// The factor of columns: a texel less the origin, times the scale, is a column.
uniform vec4 columnScale;
uniform vec4 columnOrigin;
#ifdef BENDS
uniform sampler2D bends;
#endif
#endif
uniform mat4 textureFromUnit;
// The length of one unit of unit space in world units.
uniform float worldLength;
#ifdef MASK
uniform sampler3D mask;
#endif
#ifdef TRANSMISSION
uniform sampler2D transmissions;
#endif
#if (defined(TRANSMISSION) || defined(COLOR)) && !defined(MATTER)
uniform vec4 colorColumnScale;
uniform vec4 colorColumnOrigin;
#endif
#if (defined(GRADIENT_OPACITY) || defined(SHADE)) && !defined(MATTER)
uniform vec3 voxel;
#endif
#ifdef GRADIENT_OPACITY
uniform sampler2D gradientOpacities;
// The factors by which half a difference becomes the magnitude that the functions are given for.
uniform vec3 gradientSteps;
uniform vec4 gradientColumnScale;
uniform vec4 unitDistances;
#endif

// The slab, which goes from entrance along the normal as far as spacing.
uniform vec3 sliceNormal;
uniform float sliceEntrance;
uniform float sliceSpacing;

vec3 placeInTexture(vec3 x)
{
  return (textureFromUnit * vec4(x, 1.0)).xyz;
}

//INTERLUME::CUTS

#ifndef MATTER
#ifdef BENDS
vec4 bendAt(int texel)
{
  return texelFetch(bends, ivec2(texel & (COLUMNS - 1), texel / COLUMNS), 0);
}

// Returns the value between two columns from the list of so many pieces that begins at a texel: see
// TransferColumns.
float lookUpBends(int first, int pieces, float share)
{
  // The first piece that ends after the share.
  int low = first + 1;
  int high = first + pieces;
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool isBefore = bendAt(middle).y > share;
    high = isBefore ? middle : high;
    low = isBefore ? low : middle + 1;
  }
  vec4 piece = bendAt(low);
  return mix(piece.z, piece.w, clamp((share - piece.x) / (piece.y - piece.x), 0.0, 1.0));
}
#endif

// A texel has its column's value and the next one's, or minus the place and the size of the list of
// bends between them; then what makes a share of the way a share of the edge.
float lookUp(sampler2D table, float column, int row)
{
  float place = clamp(column, 0.0, float(COLUMNS - 1));
  int first = int(place);
  float share = place - float(first);
#ifdef EDGES
  vec4 values = texelFetch(table, ivec2(first, row), 0);
#else
  vec2 values = texelFetch(table, ivec2(first, row), 0).rg;
#endif
#ifdef BENDS
  if (values.x < 0.0)
  {
    return lookUpBends(int(-values.x), int(values.y), share);
  }
#endif
#ifdef EDGES
  share = clamp(share * values.z + values.w, 0.0, 1.0);
#endif
  return mix(values.x, values.y, share);
}

#if defined(BENDS) && (defined(TRANSMISSION) || defined(COLOR))
vec3 lookUpColorBends(int first, float share)
{
  int low = first + 1;
  int high = first + int(bendAt(first).x);
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool isBefore = bendAt(middle + 1).x > share;
    high = isBefore ? middle : high;
    low = isBefore ? low : middle + 1;
  }
  vec4 left = bendAt(low);
  vec4 right = bendAt(low + 1);
  return mix(left.yzw, right.yzw, clamp((share - left.x) / max(right.x - left.x, 1e-30), 0.0, 1.0));
}
#endif

#ifdef SUMS
// Returns the extinction at a column, and the sum of extinctions from the first column to it.
vec2 lookUpSum(float column, int row)
{
  float place = clamp(column, 0.0, float(COLUMNS - 1));
  int first = int(place);
  // Sums to this column and the next one, and the extinctions there.
  vec4 sums = texelFetch(extinctionSums, ivec2(first, row), 0);
#if defined(BENDS) || defined(EDGES)
  float extinction = lookUp(extinctions, column, row);
#else
  float extinction = mix(sums.z, sums.w, place - float(first));
#endif
  // Values beyond the columns have the extinction of their ends.
  float sum = mix(sums.x, sums.y, place - float(first)) + extinction * (column - place);
  return vec2(extinction, sum);
}
#endif

#if defined(TRANSMISSION) || defined(COLOR)
// The fourth channel of a texel is the place of the bends between its column and the next one,
// minus both ends of the edge there, or 0.
vec3 lookUpColor(sampler2D table, vec4 texel, int row)
{
  float column =
    clamp((texel[row] - colorColumnOrigin[row]) * colorColumnScale[row], 0.0, float(COLUMNS - 1));
  int first = min(int(column), COLUMNS - 2);
  float share = column - float(first);
  vec4 color = texelFetch(table, ivec2(first, row), 0);
#ifdef BENDS
  if (color.a > 0.0)
  {
    return lookUpColorBends(int(color.a), share);
  }
#endif
#ifdef EDGES
  float places = float(EDGE_PLACES);
  float from = floor(-color.a / (places + 1.0));
  float to = -color.a - from * (places + 1.0);
  share = color.a < 0.0 ? clamp((share * places - from) / max(to - from, 0.01), 0.0, 1.0) : share;
#endif
  return mix(color.rgb, texelFetch(table, ivec2(first + 1, row), 0).rgb, share);
}
#endif
#endif

// Light has three channels where the matter has a colour of its own for light that passes, else one;
// PART is the share of the extinction that each meets, the same for all three where matter is GREY.
#ifdef TRANSMISSION
#define LIGHT vec3
#define CHANNELS rgb
#ifdef GREY
#define PART(texel) vec3(1.0)
#else
#define PART(texel) (1.0 - lookUpColor(transmissions, texel, 0))
#endif
#else
#define LIGHT float
#define CHANNELS r
#define PART(texel) 1.0
#endif

#ifndef MATTER
// Returns the mean of the finite samples around, and their share.
vec4 texelAt(vec3 p, out float share)
{
  vec4 texel = texture(volume, p);
  share = 1.0;
#ifdef MASK
  share = texture(mask, p).r;
  texel /= max(share, 1e-6);
#endif
  return texel;
}

#if defined(GRADIENT_OPACITY) || defined(SHADE)
// Finds the differences of the texel over two voxels along each axis of the texture.
void differencesAt(vec3 p, vec4 here, out vec4 differences[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 offset = vec3(0.0);
    offset[axis] = voxel[axis];
    float share;
    vec4 before = texelAt(p - offset, share);
    before = share > 0.0 ? before : here;
    vec4 after = texelAt(p + offset, share);
    after = share > 0.0 ? after : here;
    differences[axis] = after - before;
  }
}

// Return the length of v, and its direction, where squares of its components may be below all
// numbers.
float lengthOf(vec3 v)
{
  float size = max(max(abs(v.x), abs(v.y)), abs(v.z));
  return size > 0.0 ? size * length(v / size) : 0.0;
}

// Returns the direction in unit space of the gradient of one component, from its differences.
vec3 gradientOf(vec3 difference)
{
  float size = max(max(abs(difference.x), abs(difference.y)), abs(difference.z));
  return normalize((difference / size / voxel) * mat3(textureFromUnit));
}
#endif
#endif

#ifdef MATTER
// What a fragment's sample stands for, in the texture: a piece of the ray and the edges of a pixel.
mat3 sampleSize = mat3(0.0);

// Sets the size from a piece of a ray along d, and the edges of a pixel around, in unit space.
void setSampleSize(vec3 d, float piece, vec3 x, vec3 y)
{
  sampleSize =
    mat3(textureFromUnit) * mat3(piece * d, x - dot(x, d) * d, y - dot(y, d) * d);
}

// Finds the extinction at x, which is p in the texture; the texel is the colour.
float extinctionsAt(vec3 x, vec3 p, out vec4 texel, out vec4 parts)
{
  texel = vec4(0.0);
  parts = vec4(0.0);
  vec3 color = vec3(0.0);
  parts.x = mediumAt(p, sampleSize, color) * worldLength;
  texel = vec4(color, 0.0);
  return parts.x;
}
#else
// Finds the extinction of each row at x, which is p in the texture, and returns their sum.
float extinctionsAt(vec3 x, vec3 p, out vec4 texel, out vec4 parts)
{
  parts = vec4(0.0);
  float share;
  texel = texelAt(p, share);
  vec4 columns = (texel - columnOrigin) * columnScale;
#if ROWS == 1
  parts.x = lookUp(extinctions, columns.OPACITY_OF, 0) * (share * worldLength);
#else
  for (int row = 0; row < ROWS; ++row)
  {
    parts[row] = lookUp(extinctions, columns[row], row) * (share * worldLength);
  }
#endif
#ifdef GRADIENT_OPACITY
  if (dot(parts, vec4(1.0)) > 0.0)
  {
    vec4 differences[3];
    differencesAt(p, texel, differences);
    for (int row = 0; row < ROWS; ++row)
    {
#if ROWS == 1
      vec3 difference =
        vec3(differences[0].OPACITY_OF, differences[1].OPACITY_OF, differences[2].OPACITY_OF);
#else
      vec3 difference = vec3(differences[0][row], differences[1][row], differences[2][row]);
#endif
      float factor = lookUp(
        gradientOpacities, lengthOf(difference * gradientSteps) * gradientColumnScale[row], row);
      float opacity = 1.0 - exp(-parts[row] * unitDistances[row]);
      parts[row] = -log(max(1.0 - opacity * factor, 1e-30)) / unitDistances[row];
    }
  }
#endif
  return dot(parts, vec4(1.0));
}
#endif

#ifdef SUMS
#if ROWS == 1
#define VALUES float
#else
#define VALUES vec4
#endif

// A place between which and another values change evenly: columns of each row's opacities, the
// extinctions there and their sums up to there, and the share of matter.
struct Place
{
  VALUES Columns;
  VALUES Extinctions;
  VALUES Sums;
  float Share;
  vec4 Texel;
};

Place placeOf(VALUES columns, float share, vec4 texel)
{
  Place place;
  place.Columns = columns;
  place.Share = share;
  place.Texel = texel;
#if ROWS == 1
  vec2 found = lookUpSum(columns, 0);
  place.Extinctions = found.x;
  place.Sums = found.y;
#else
  place.Extinctions = vec4(0.0);
  place.Sums = vec4(0.0);
  for (int row = 0; row < ROWS; ++row)
  {
    vec2 found = lookUpSum(columns[row], row);
    place.Extinctions[row] = found.x;
    place.Sums[row] = found.y;
  }
#endif
  return place;
}

float extinctionOf(Place place)
{
#if ROWS == 1
  return place.Extinctions * place.Share;
#else
  return dot(place.Extinctions, vec4(1.0)) * place.Share;
#endif
}

Place placeOfTexel(vec4 texel, float share)
{
  vec4 columns = (texel - columnOrigin) * columnScale;
#if ROWS == 1
  return placeOf(columns.OPACITY_OF, share, texel);
#else
  return placeOf(columns, share, texel);
#endif
}

// Finds the place x, which is p in the texture. Opacity by gradients is part of the share, and so is
// cropping, but of spans, which are cut before.
Place placeAt(vec3 x, vec3 p)
{
  float share;
  vec4 texel = texelAt(p, share);
#if defined(CROPPING) && !defined(SPANS)
  share = isCropped(x) ? 0.0 : share;
#endif
  Place place = placeOfTexel(texel, share * worldLength);
#ifdef GRADIENT_OPACITY
  float whole = extinctionOf(place);
  vec4 parts;
  float left = extinctionsAt(x, p, texel, parts);
  place.Share *= whole > 0.0 ? left / whole : 0.0;
#endif
  return place;
}

Place placeBetween(Place a, Place b, float part)
{
  return placeOf(mix(a.Columns, b.Columns, part), mix(a.Share, b.Share, part), a.Texel);
}

#ifdef SPANS
// Finds the matter at both ends of a way, of which p + q t is the place in the texture: on the line
// through the values at the points of Gauss's formula for two points, which is nearest to what they
// are on the way.
void spanOf(vec3 p, vec3 q, float lower, float upper, out Place start, out Place end)
{
  const float inset = 0.21132487;
  const float beyond = 0.36602540;
  float firstShare;
  float lastShare;
  vec4 first = texelAt(p + q * mix(lower, upper, inset), firstShare);
  vec4 last = texelAt(p + q * mix(upper, lower, inset), lastShare);
  float share = 0.5 * (firstShare + lastShare) * worldLength;
  start = placeOfTexel(mix(first, last, -beyond), share);
  end = placeOfTexel(mix(last, first, -beyond), share);
}
#endif

// Returns the mean extinctions of the rows on the way from one place to another.
VALUES meanExtinctions(Place a, Place b)
{
  VALUES change = b.Columns - a.Columns;
  VALUES mean = 0.5 * (a.Extinctions + b.Extinctions);
  // Sums up to nearly the same column have no digits for their difference.
#if ROWS == 1
  mean = abs(change) < 0.5 ? mean : (b.Sums - a.Sums) / change;
#else
  for (int row = 0; row < ROWS; ++row)
  {
    mean[row] = abs(change[row]) < 0.5 ? mean[row] : (b.Sums[row] - a.Sums[row]) / change[row];
  }
#endif
  return 0.5 * (a.Share + b.Share) * max(mean, VALUES(0.0));
}

// Returns the same of all rows together.
float meanExtinction(Place a, Place b)
{
#if ROWS == 1
  return meanExtinctions(a, b);
#else
  return dot(meanExtinctions(a, b), vec4(1.0));
#endif
}

// Returns where between two places, 0 to 1, the matter on the way is on the average.
float middleOf(Place a, Place b)
{
  float first = extinctionOf(a);
  float last = extinctionOf(b);
  float sum = first + last;
  return sum > 0.0 ? (first + 2.0 * last) / (3.0 * sum) : 0.5;
}

// Returns the optical depth of a way of a length from one place to another.
LIGHT depthBetween(Place a, Place b, float length)
{
  return meanExtinction(a, b) * length * PART(mix(a.Texel, b.Texel, middleOf(a, b)));
}

#ifdef TRANSMISSION
float largestOf(vec3 light)
{
  return max(max(light.r, light.g), light.b);
}
#else
float largestOf(float light)
{
  return light;
}
#endif

#ifdef THICK
// Returns whether extinctions jump on the way: in the middle they are far from the mean of both
// ends.
bool jumps(Place a, Place b)
{
  float first = extinctionOf(a);
  float last = extinctionOf(b);
  float middle = extinctionOf(placeBetween(a, b, 0.5));
  return abs(middle - 0.5 * (first + last)) > 0.45 * max(first, last);
}

// Returns the optical depth of a slab's matter, between lower and upper on x + s d, p and q in the
// texture, whose sample in the middle has an extinction. Slabs are across long, matter is from
// start to end. Where extinctions jump to nothing on the way to the next slab's sample that slab
// shows nothing of what is there; then lower or upper moves to where the matter begins or ends.
// isFront is set where extinctions jump before the sample.
float depthOfSlab(vec3 x, vec3 d, vec3 p, vec3 q, float across, float start, float end,
  float extinction, inout float lower, inout float upper, inout bool isFront)
{
  float middle = 0.5 * (lower + upper);
  float size = 0.5 * (upper - lower);
  Place here = placeAt(x + d * middle, p + q * middle);
  vec2 borders = vec2(lower, upper);
  float depth = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    float sign = i == 0 ? -1.0 : 1.0;
    float last = i == 0 ? start : end;
    float next = 0.5 * (borders[i] + sign * min(sign * borders[i] + across, sign * last));
    float way = abs(next - middle);
    Place there = placeAt(x + d * next, p + q * next);
    float share = extinction * size;
    if (abs(last - borders[i]) > 0.01 * across && jumps(here, there))
    {
      bool isLeft = extinctionOf(there) > 0.05 * extinction;
      share = isLeft ? meanExtinction(here, placeBetween(here, there, size / way)) * size
                     : meanExtinction(here, there) * way;
      float reach = isLeft ? size : min(share / extinction, way);
      borders[i] = middle + sign * reach;
      isFront = isFront || i == 0;
    }
    depth += share;
  }
  lower = borders.x;
  upper = borders.y;
  return max(depth, 1e-6);
}
#endif
#endif
