#version 330 core
// Light to pixels: bloom on top, then the tone curve.
in vec2 at;

uniform sampler2D picture;
uniform sampler2D bloom;
uniform float bloom_strength;

out vec4 pixel;

vec3 tone_mapped(vec3 light);

void main() {
    vec3 light = texture(picture, at).rgb + bloom_strength * texture(bloom, at).rgb;
    pixel = vec4(tone_mapped(light), 1.0);
}
