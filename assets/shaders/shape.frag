#version 330 core
// As overlay.frag, for what is no text: a look into the atlas is what costs a software rasteriser most.
in vec4 shade;

out vec4 colour;

void main() { colour = shade; }
