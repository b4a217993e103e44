#version 300 es
// Corners of triangles. The three corners of a triangle follow each other, so the number of a corner gives its place.
in vec3 position;
in vec3 normal;
in uint flags;  // bits 0 to 2: the side from this corner on is an edge; 3: laid bare by a cut
in float value;
in vec4 paint;
in vec3 sides;
in vec2 texture_place;
uniform mat4 project;
uniform mat3 turn;
out vec3 place;
out vec3 direction;
out vec3 inside;
out float number;
out vec4 painted;
flat out uint bits;
flat out vec3 side_numbers;
flat out int triangle;
out vec2 uv;

void main() {
  gl_Position = project * vec4(position, 1.0);
  place = position;
  direction = turn * normal;
  int corner = gl_VertexID % 3;
  inside = vec3(corner == 0, corner == 1, corner == 2);
  number = value;
  painted = paint;
  bits = flags;
  side_numbers = sides;
  triangle = gl_VertexID / 3;
  uv = texture_place;
}
