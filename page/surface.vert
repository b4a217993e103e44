#version 300 es
// Corners of triangles. The three corners of a triangle follow each other, so the number of a corner gives its place. What is
// not needed is left out, by the names that the program defines.
in vec3 position;
uniform mat4 project;
uniform mat3 turn;
#ifdef PLACE
out vec3 place;
#endif
#ifdef SMOOTH
in vec3 normal;
out vec3 direction;
#endif
#ifdef BITS
in uint flags;  // bits 0 to 2: the side from this corner on is an edge; 3: laid bare by a cut
flat out uint bits;
#endif
#ifdef VALUES
in float value;
out float number;
#endif
#ifdef PAINT
in vec4 paint;
out vec4 painted;
#endif
#ifdef EDGES
out vec3 inside;
#endif
#ifdef SIDES
in vec3 sides;
flat out vec3 side_numbers;
#endif
#ifdef TEXTURE
in vec2 texture_place;
out vec2 uv;
#endif
#ifdef PICK
flat out int triangle;
#endif

void main() {
  gl_Position = project * vec4(position, 1.0);
#ifdef PLACE
  place = position;
#endif
#ifdef SMOOTH
  direction = turn * normal;
#endif
#ifdef BITS
  bits = flags;
#endif
#ifdef VALUES
  number = value;
#endif
#ifdef PAINT
  painted = paint;
#endif
#ifdef EDGES
  int corner = gl_VertexID % 3;
  inside = vec3(corner == 0, corner == 1, corner == 2);
#endif
#ifdef SIDES
  side_numbers = sides;
#endif
#ifdef TEXTURE
  uv = texture_place;
#endif
#ifdef PICK
  triangle = gl_VertexID / 3;
#endif
}
