#version 330 core
in vec2 at;
in vec4 shade;

uniform sampler2D atlas;

out vec4 colour;

void main() {
    // texelFetch reads by texel, so a glyph is drawn pixel for pixel.
    colour = vec4(shade.rgb, shade.a * texelFetch(atlas, ivec2(at), 0).r);
}
