#version 330 core
in vec3 shade;

out vec4 pixel;

// No dither: noise of one step would hide the faint bands of 8 bits, but cost a software rasteriser 3 ms a
// frame.
void main() { pixel = vec4(shade, 1.0); }
