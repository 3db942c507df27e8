#version 450 core
// A triangle mesh for the geometry buffers: normals follow the surface, ids the triangles.
layout(location = 0) in vec3 position;  // body frame, m, relative to the mesh's own origin
layout(location = 1) in vec3 normal;    // body frame
uniform mat4 clip_from_body;
uniform mat3 view_from_body;
out vec3 view_normal;

void main() {
  gl_Position = clip_from_body * vec4(position, 1.0);
  view_normal = view_from_body * normal;
}
