#version 330 core
// Flat shade on the ground; its colour multiplies the colour behind it.
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 colour;
layout(location = 3) in mat4 model;
layout(location = 7) in vec4 tint_glow;

uniform mat4 view_projection;

out vec3 shade;

void main() {
    // The tint's red is the strength of the shade: 0 changes nothing.
    shade = mix(vec3(1.0), colour, tint_glow.r);
    gl_Position = view_projection * (model * vec4(position, 1.0));
}
