#version 330 core
// Depth is all that is kept.
void main() {}
