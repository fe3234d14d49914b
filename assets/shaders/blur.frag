#version 330 core
// One direction of a Gaussian blur; `way` is a step of one texel in that direction.
in vec2 at;

uniform sampler2D picture;
uniform vec2 way;

out vec4 pixel;

void main() {
    // Weights exp(-0.12 i^2) of the texels i = -4 to 4, divided by their sum. One lookup between two texels
    // returns both, mixed by their weights.
    vec3 sum = 0.200650 * texture(picture, at).rgb;
    for (int side = -1; side <= 1; side += 2) {
        vec2 step = float(side) * way;
        sum += 0.302119 * texture(picture, at + 1.410959 * step).rgb;
        sum += 0.097556 * texture(picture, at + 3.301535 * step).rgb;
    }
    pixel = vec4(sum, 1.0);
}
