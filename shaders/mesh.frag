#version 450 core
in vec3 view_normal;
layout(location = 0) out uint id;      // 1 + triangle; 0 is the background
layout(location = 1) out vec2 normal;  // x, y of the unit normal; z = sqrt(1 - x^2 - y^2) >= 0

void main() {
  // The inside of an open surface is lit like the outside: its normal turned towards the viewer.
  vec3 n = view_normal * inversesqrt(max(dot(view_normal, view_normal), 1e-12));
  normal = n.z < 0.0 ? -n.xy : n.xy;
  id = uint(gl_PrimitiveID) + 1u;
}
