#version 330 core
// Shade and sun come as pixels from each vertex; the shadow map says how much of the sun there is.
in vec3 shade;
in vec3 sunlight;
in vec3 in_map;

out vec4 pixel;

float sun_share(vec3 in_map);

void main() { pixel = vec4(shade + sunlight * sun_share(in_map), 1.0); }
