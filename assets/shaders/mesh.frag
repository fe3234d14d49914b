#version 330 core
in vec3 radiance;
in vec3 from_eye;

uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2

out vec4 pixel;

vec3 tone_mapped(vec3 light);

void main() {
    float clear = exp2(-fog_rate * dot(from_eye, from_eye));
    pixel = vec4(tone_mapped(mix(fog_colour, radiance, clear)), 1.0);
}
