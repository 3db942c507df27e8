#version 450 core
in vec2 offset;
flat in vec3 view_normal;
flat in uint point_id;
uniform float radius_in_depth;  // the disc's radius in units of the depth buffer
layout(location = 0) out uint id;      // 1 + point; 0 is the background
layout(location = 1) out vec2 normal;  // x, y of the unit normal; z = sqrt(1 - x^2 - y^2) >= 0

void main() {
  // Discs seen nearly edge-on would vanish; they keep a fifth of their width.
  float rise = -dot(view_normal.xy, offset) / max(view_normal.z, 0.2);
  float squared = dot(offset, offset) + rise * rise;
  if (squared > 1.0) discard;
  // Neighbouring discs share a plane. Sinking with the distance from the centre gives every pixel
  // to the nearest point, so ids and labels meet half-way between points.
  gl_FragDepth = gl_FragCoord.z + radius_in_depth * (0.5 * squared - rise);
  normal = view_normal.xy;
  id = point_id;
}
