#version 330 core
// Overlay shapes without text. They skip the atlas lookup of overlay.frag, which costs a software rasteriser
// most.
in vec4 shade;

out vec4 colour;

void main() { colour = shade; }
