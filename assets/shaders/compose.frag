#version 330 core
// Final pass: the light of one view plus bloom, through the tone curve.
in vec2 at;
in vec2 within;

uniform vec4 part;
uniform sampler2D picture;
uniform sampler2D bloom;
uniform float bloom_strength;

out vec4 pixel;

vec3 tone_mapped(vec3 light);

void main() {
    // Stays half a texel inside the edge, so that filtering reads nothing of the neighbouring view.
    vec2 edge = 0.5 / vec2(textureSize(picture, 0));
    vec2 place = clamp(at, part.xy + edge, part.xy + part.zw - edge);
    vec3 light = texture(picture, place).rgb + bloom_strength * texture(bloom, within).rgb;
    pixel = vec4(tone_mapped(light), 1.0);
}
