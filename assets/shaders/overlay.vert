#version 330 core
layout(location = 0) in vec2 position;  // px from the top left corner
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;

uniform vec2 pixel;  // size of a pixel in a window of 2 x 2

out vec2 at;
out vec4 shade;

void main() {
    at = texel;
    shade = colour;
    gl_Position = vec4(position.x * pixel.x - 1.0, 1.0 - position.y * pixel.y, 0.0, 1.0);
}
