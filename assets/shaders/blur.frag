#version 330 core
// One direction of a Gaussian blur; `way` is a step of one texel in that direction.
in vec2 at;

uniform sampler2D picture;
uniform vec2 way;

out vec4 pixel;

void main() {
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = -5; i <= 5; ++i) {
        float weight = exp(-0.12 * float(i * i));
        sum += weight * texture(picture, at + float(i) * way).rgb;
        weights += weight;
    }
    pixel = vec4(sum / weights, 1.0);
}
