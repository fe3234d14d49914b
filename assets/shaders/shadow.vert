#version 330 core
// What the sun sees.
layout(location = 0) in vec3 position;
layout(location = 3) in mat4 model;

uniform mat4 view_projection;

void main() { gl_Position = view_projection * (model * vec4(position, 1.0)); }
