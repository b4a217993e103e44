#version 300 es
// The colour of a pixel of a triangle, or, to pick, the numbers of the object and the triangle.
precision highp float;
precision highp int;
uniform mat3 turn;
uniform bool parallel;        // rays
uniform vec3 eye;
out vec4 result;

#ifdef PLACE
in vec3 place;
#endif
#ifdef BITS
flat in uint bits;
#endif

#ifdef CUTS
uniform vec4 planes[4];
uniform int cuts;             // bit k: what is above plane k is cut away
/// The distance to the nearest cut, in pixels. What is cut away is not drawn.
float distance_to_cut() {
  float nearest = 1e9;
  for (int k = 0; k < 4; ++k) {
    float gap = planes[k].w - dot(planes[k].xyz, place), step = fwidth(gap);
    if ((cuts >> k & 1) == 0) continue;
    if (gap <= 0.0) discard;
    nearest = min(nearest, gap / max(step, 1e-9));
  }
  return nearest;
}
#endif

#ifdef PICK
flat in int triangle;
uniform int picking;          // the number of the object
void main() {
#ifdef CUTS
  distance_to_cut();
#endif
  result = vec4(float(picking), float(triangle & 255), float(triangle >> 8 & 255), float(triangle >> 16 & 255)) / 255.0;
}
#else

uniform vec3 color, exposed_color, no_value, edge_color;
uniform float opacity, shine;
uniform sampler2D map;

vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
/// sRGB by roots, which are faster than powers: at most 0.002 from the exact curve.
vec3 screen(vec3 c) {
  vec3 a = sqrt(clamp(c, 0.0, 1.0)), b = sqrt(a);
  return clamp(0.585122381 * a + 0.783140355 * b - 0.368262736 * sqrt(b), 0.0, 1.0);
}

/// How much of the pixel a line covers that is where x is 1/2, 3/2, 5/2 ...; width in pixels.
float line_at(float x, float width) {
  float w = max(fwidth(x), 1e-6);
  return clamp(width * 0.5 + 0.5 - abs(fract(x) - 0.5) / w, 0.0, 1.0);
}

#if defined(VALUES) || defined(SIDES)
uniform vec2 knots[18];
uniform int num_knots;
uniform bool are_labels;
float position_of(float x) {
  if (num_knots == 2) return mix(knots[0].y, knots[1].y, clamp((x - knots[0].x) / (knots[1].x - knots[0].x), 0.0, 1.0));
  float t = knots[0].y;
  for (int i = 0; i + 1 < num_knots; ++i) {
    vec2 a = knots[i], b = knots[i + 1];
    if (x >= a.x) t = b.x > a.x ? mix(a.y, b.y, clamp((x - a.x) / (b.x - a.x), 0.0, 1.0)) : mix(a.y, b.y, 0.5);
  }
  return t;
}
vec3 color_of(float x) {
  if (abs(x) > 1e30) return no_value;
  if (are_labels) return texelFetch(map, ivec2(int(mod(floor(x + 0.5), 256.0)), 0), 0).rgb;
  return texture(map, vec2((position_of(x) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
#endif

#ifdef VALUES
in float number;
#ifdef LINES
uniform float bands, lines;   // how many
uniform vec2 band_widths;     // half of it, in distances between bands, and at most in pixels
vec3 color_of_surface() {
  vec3 c = color_of(number);
  float t = position_of(number), x = t * bands, w = max(fwidth(x), 1e-6), line = line_at(t * lines, 1.5);
  if (abs(number) > 1e30) return c;
  if (bands > 0.0) c = mix(c, vec3(1.0), clamp((min(band_widths.x, band_widths.y * w) - abs(fract(x) - 0.5)) / w + 0.5, 0.0, 1.0));
  return lines > 0.0 ? mix(c, edge_color, line) : c;
}
#else
vec3 color_of_surface() { return color_of(number); }
#endif
#elif defined(PAINT)
in vec4 painted;
vec3 color_of_surface() { return linear(painted.rgb); }
#else
vec3 color_of_surface() { return (bits & 8u) != 0u ? exposed_color : color; }
#endif

#ifdef TEXTURE
in vec2 uv;
uniform int texture_kind;     // 1: squares, 2: lines, 3: a picture
uniform vec2 texture_size;    // squares or lines in a unit, and the width of lines in pixels
uniform vec3 texture_first, texture_second;
uniform sampler2D picture;
/// The mean over a pixel of 1 in even intervals and -1 in odd ones: differences of its integral.
float mean_sign(float x) {
  float w = max(fwidth(x), 1e-6);
  vec2 ends = abs(mod(x + vec2(0.5, -0.5) * w, 2.0) - 1.0);
  return w > 2.0 ? 0.0 : (ends.y - ends.x) / w;
}
vec3 with_texture(vec3 below) {
  bool has_no_place = max(abs(uv.x), abs(uv.y)) > 1e30;
  if (texture_kind == 3) {
    vec4 t = texture(picture, vec2(uv.x, 1.0 - uv.y));
    return has_no_place ? no_value : below * (1.0 - t.a) + t.rgb;
  }
  vec2 x = uv * texture_size.x;
  if (texture_kind == 1) {
    float share = 0.5 - 0.5 * mean_sign(x.x) * mean_sign(x.y);
    below = mix(texture_first, texture_second, share);
  } else below = mix(texture_first, below, (1.0 - line_at(x.x + 0.5, texture_size.y)) * (1.0 - line_at(x.y + 0.5, texture_size.y)));
  return has_no_place ? no_value : below;
}
#endif

/// The normal that points to the viewer, in the frame of the camera.
#ifdef SMOOTH
in vec3 direction;
vec3 normal_to_viewer() {
  vec3 n = direction * inversesqrt(max(dot(direction, direction), 1e-12));
  return gl_FrontFacing ? n : -n;
}
#else
vec3 normal_to_viewer() {
  vec3 n = normalize(turn * cross(dFdx(place), dFdy(place)));
  return dot(n, parallel ? vec3(0, 0, -1) : turn * (place - eye)) > 0.0 ? -n : n;
}
#endif

#ifdef BALL
uniform sampler2D ball;
vec3 light_at(vec3 n) { return texture(ball, n.xy * vec2(0.49, -0.49) + 0.5).rgb; }
#else
vec3 light_at(vec3 n) {
  vec3 to_light = normalize(vec3(-0.55, 0.9, 0.75));
  float light = 0.34 + 0.14 * n.y + 0.34 * max(n.z, 0.0) + 0.42 * max(dot(n, to_light), 0.0);
  float x = max(dot(n, normalize(to_light + vec3(0, 0, 1))), 0.0), y = x * x * x * x, z = y * y * y;
  return vec3(light + shine * 0.10 * z * z * z * y);  // x to the 40th
}
#endif

#ifdef EDGES
in vec3 inside;
uniform float edge_width;
#ifdef SIDES
flat in vec3 side_numbers;
#endif
void draw_edges(inout vec3 lit, inout float cover) {
  vec3 slope = fwidth(inside);
  for (int k = 0; k < 3; ++k) {
    if ((bits >> k & 1u) == 0u) continue;
    int opposite = (k + 2) % 3;
    float drawn = clamp(edge_width * 0.5 + 0.5 - inside[opposite] / max(slope[opposite], 1e-9), 0.0, 1.0);
#ifdef SIDES
    lit = mix(lit, color_of(side_numbers[k]), drawn);
#else
    lit = mix(lit, edge_color, drawn * 0.6);
#endif
    cover = max(cover, drawn * 0.6);
  }
}
#endif

void main() {
#ifdef CUTS
  float to_cut = distance_to_cut();
#endif
  vec3 base = color_of_surface();
#ifdef TEXTURE
  base = with_texture(base);
#endif
  vec3 lit = base * light_at(normal_to_viewer());
  float cover = opacity;
#ifdef EDGES
  draw_edges(lit, cover);
#endif
#ifdef CUTS
  if (to_cut < 3.0) lit = mix(lit, edge_color, clamp(2.0 - to_cut, 0.0, 1.0));
#endif
  result = vec4(screen(lit) * cover, cover);
}
#endif
