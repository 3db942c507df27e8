#version 450 core
// A point of a cloud, drawn as a disc that lies in the surface. Each point comes three times: the
// corners of a triangle round the disc, which is drawn faster than a point of OpenGL.
layout(location = 0) in vec3 position;  // body frame, m, relative to the cloud's own origin
layout(location = 1) in vec3 normal;    // body frame
layout(location = 2) in uint point;
uniform mat4 clip_from_body;
uniform mat3 view_from_body;
uniform vec2 radius;  // of the disc in clip coordinates, across and up
out vec2 offset;      // from the point, in radii; up is positive
flat out vec3 view_normal;
flat out uint point_id;

const vec2 corners[3] = vec2[3](vec2(0.0, 2.0), vec2(-1.7320508, -1.0), vec2(1.7320508, -1.0));

void main() {
  offset = corners[gl_VertexID % 3];
  gl_Position = clip_from_body * vec4(position, 1.0) + vec4(radius * offset, 0.0, 0.0);
  vec3 n = view_from_body * normal;
  view_normal = n.z < 0.0 ? -n : n;
  point_id = point + 1u;
}
