#version 450 core
// Coverage only: pixels whose centre lies inside the projected mesh.
layout(location = 0) in vec3 position;  // body frame, m, relative to the mesh's own origin
uniform mat4 clip_from_body;

void main() { gl_Position = clip_from_body * vec4(position, 1.0); }
