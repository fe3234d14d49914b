#version 330 core
// One view's light to pixels: bloom on top, then the tone curve.
in vec2 at;
in vec2 within;

uniform vec4 part;
uniform sampler2D picture;
uniform sampler2D bloom;
uniform float bloom_strength;

out vec4 pixel;

vec3 tone_mapped(vec3 light);

void main() {
    // Half a texel from the edge, so that filtering takes nothing from the view beside this one.
    vec2 edge = 0.5 / vec2(textureSize(picture, 0));
    vec2 place = clamp(at, part.xy + edge, part.xy + part.zw - edge);
    vec3 light = texture(picture, place).rgb + bloom_strength * texture(bloom, within).rgb;
    pixel = vec4(tone_mapped(light), 1.0);
}
