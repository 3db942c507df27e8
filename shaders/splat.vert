#version 450 core
// A point of a cloud, drawn as a disc that lies in the surface.
layout(location = 0) in vec3 position;  // body frame, m, relative to the cloud's own origin
layout(location = 1) in vec3 normal;    // body frame
uniform mat4 clip_from_body;
uniform mat3 view_from_body;
uniform float diameter;  // pixels
flat out vec3 view_normal;
flat out uint point_id;

void main() {
  gl_Position = clip_from_body * vec4(position, 1.0);
  gl_PointSize = diameter;
  vec3 n = view_from_body * normal;
  view_normal = n.z < 0.0 ? -n : n;
  point_id = uint(gl_VertexID) + 1u;
}
