#version 330 core
// Shade and sunlight arrive as tone-mapped colours from each vertex. The shadow map gives the share of the
// sunlight.
in vec3 shade;
in vec3 sunlight;
in vec3 in_map;

out vec4 pixel;

float sun_share(vec3 in_map);

void main() { pixel = vec4(shade + sunlight * sun_share(in_map), 1.0); }
