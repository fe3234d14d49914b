#version 330 core
// Depth of the scene as seen from the sun.
layout(location = 0) in vec3 position;
layout(location = 3) in mat4 model;

uniform mat4 view_projection;

void main() { gl_Position = view_projection * (model * vec4(position, 1.0)); }
