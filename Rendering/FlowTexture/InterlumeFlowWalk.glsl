// Walks a line of sight, sample by sample. A sample stands for the piece of the ray around it; the
// last one is shorter.

struct Ray
{
  vec3 Origin;
  vec3 Way;
  // The length of the ray's direction, in world units.
  float Unit;
  float Lower;
  float Upper;
  // Where the next sample's piece begins, and the number of samples before it.
  float From;
  float Number;
};

bool goesOn(Ray ray, vec4 sum)
{
  return ray.From < ray.Upper && sum.a < OPAQUE_ENOUGH;
}

float pieceOf(Ray ray)
{
  return min(sampleDistance, ray.Upper - ray.From);
}

vec3 placeOf(Ray ray)
{
  return ray.Origin + (ray.From + 0.5 * pieceOf(ray)) * ray.Way;
}

vec3 cellOf(vec3 place)
{
  return clamp(floor(place), vec3(0.0), lastCell);
}

void pass(inout Ray ray, float samples)
{
  ray.Number += samples;
  ray.From = ray.Lower + ray.Number * sampleDistance;
}

// Adds what is painted at a place, in so many pieces.
void add(Ray ray, Sample found, vec3 place, int pieces, inout vec4 sum)
{
  float depth = pieceOf(ray) / (unitDistance * float(pieces));
  float strength = strengthAt(place);
#ifdef CROPPING
  strength = isCropped(place) ? 0.0 : strength;
#endif
#ifdef SHADE
  Light light = lightAt(place, ray.Way);
#endif
  for (int i = 0; i < pieces && strength > 0.0; ++i)
  {
#ifdef PAINT_FILTER
    vec4 paint = paintFrom(found, i, pieces) * strength;
#else
    vec4 paint = paintOf(found, 0.0) * strength;
#endif
    if (paint.a > 0.0)
    {
      float opacity = opacityOf(paint.a, depth);
      vec3 color = paint.rgb * (opacity / paint.a);
#ifdef SHADE
      color = color * light.Diffuse + opacity * light.Specular;
#endif
      sum += (1.0 - sum.a) * vec4(color, opacity);
    }
  }
}

#ifdef PAINT_FILTER
Footprint footprintOf(Ray ray, float from, float piece)
{
  float share = (from + 0.5 * piece) / ray.Unit;
  return Footprint(ray.Way * piece, (rayOriginX + share * rayDirectionX) * pixelSize.x,
    (rayOriginY + share * rayDirectionY) * pixelSize.y);
}

// How far what a sample stands for may reach, in voxels; between two ways it is never further.
float reachOf(Ray ray, float from)
{
  return reachOf(footprintOf(ray, from - 0.5 * sampleDistance, sampleDistance));
}

// Adds what is painted at a place of one cell, and of the size that the sample stands for.
void addWide(Ray ray, Sample found, Footprint footprint, vec3 place, inout vec4 sum)
{
  int pieces = 1;
  if (found.IsWide)
  {
    setFootprint(found, footprint);
    pieces = found.IsAlongRay ? piecesOf(found) : 1;
  }
  add(ray, found, place, pieces, sum);
}
#endif

#ifdef SMOOTH_PLACES
// Software executes both sides of each branch, so what few samples need has a loop of its own,
// which is gone through as often as one of the rays beside each other needs it.

// Walks while samples have nothing, or one surface and no more than two texels.
void walkSmooth(inout Ray ray, float reach, float stride, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
    vec4 stored = storedAt(place);
    if (stored.a > LARGEST_LABEL || stored.b * reach > 2.0)
    {
      break;
    }
    if (stored.a > 0.0)
    {
      Sample found;
      setSurface(found, int(stored.a));
      lookUpPlace(place, found);
#ifdef PAINT_FILTER
      found.IsWide = false;
#endif
      add(ray, found, place, 1, sum);
    }
    // The distance from a place is at most 1 less than that from its cell.
    pass(ray, max(floor((-1.0 - stored.a) * stride), 1.0));
  }
}

#ifdef PAINT_FILTER
// Walks on in cells of one surface, and while samples there may have more than two texels.
void walkWide(inout Ray ray, inout vec4 sum)
{
  bool isStillWide = true;
  while (isStillWide && goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    if (stored.x == SPLIT || stored.x >= SPLIT_BY_WAYS)
    {
      break;
    }
    Footprint footprint = footprintOf(ray, ray.From, pieceOf(ray));
    Sample found;
    isStillWide = isWide(stored.y, footprint);
    found.IsWide = isStillWide;
    setSurface(found, stored.x);
    lookUpPlain(ivec3(cell), place - cell, found);
    addWide(ray, found, footprint, place, sum);
    pass(ray, 1.0);
  }
}
#endif
#endif

// Walks through cells of all kinds; where most are walked by themselves, while there are others.
void walkCells(inout Ray ray, vec3 inverse, inout vec4 sum)
{
  while (goesOn(ray, sum))
  {
    vec3 place = placeOf(ray);
#ifdef SMOOTH_PLACES
    if (storedAt(place).a < LARGEST_LABEL)
    {
      break;
    }
#endif
    vec3 cell = cellOf(place);
    ivec2 stored = kindAt(ivec3(cell));
    float samples = 1.0;
    if (stored.x >= EMPTY)
    {
      // All cells nearer than the distance are empty: the samples there are passed over.
      float distance = float(stored.x - EMPTY);
      vec3 ends = mix(cell + 1.0 - distance, cell + distance, greaterThan(ray.Way, vec3(0.0)));
      vec3 exits = (ends - place) * inverse;
      samples += max(ceil(min(min(exits.x, exits.y), exits.z) / sampleDistance) - 1.0, 0.0);
    }
    else
    {
      Sample found;
#ifdef PAINT_FILTER
      Footprint footprint = footprintOf(ray, ray.From, pieceOf(ray));
      found.IsWide = isWide(stored.y, footprint);
      if (lookUpCell(place, cell, stored.x, found.IsWide, found))
      {
        addWide(ray, found, footprint, place, sum);
      }
#else
      if (lookUpCell(place, cell, stored.x, false, found))
      {
        add(ray, found, place, 1, sum);
      }
#endif
    }
    pass(ray, samples);
  }
}
