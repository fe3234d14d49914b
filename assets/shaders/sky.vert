#version 330 core
// The sky at the far end of the depth range, as a grid over the view: it is so smooth that its colour is worked out
// (and tone mapped) at 17 x 11 corners instead of at each pixel, of which a software rasteriser does a million. HDR leaves the tone curve to the last pass.
uniform vec3 forward;
uniform vec3 right;
uniform vec3 up;
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 sun_direction;
uniform vec3 sun_glow;
uniform vec3 fog_colour;

out vec3 shade;

vec3 tone_mapped(vec3 light);

const ivec2 cells = ivec2(16, 10);

vec2 corner() {
    int cell = gl_VertexID / 6, k = gl_VertexID % 6;
    // Two triangles: corners 0 1 2 and 2 1 3 of the cell.
    int of_cell = k < 3 ? k : (k == 3 ? 2 : (k == 4 ? 1 : 3));
    ivec2 at = ivec2(cell % cells.x, cell / cells.x) + ivec2(of_cell & 1, of_cell >> 1);
    return 2.0 * vec2(at) / vec2(cells) - 1.0;
}

vec3 sky(vec3 d) {
    float up_away = 1.0 - clamp(d.y, 0.0, 1.0);
    float low = up_away * up_away * up_away;
    float near_sun = max(dot(d, sun_direction), 0.0);
    float wide = pow(near_sun, 4.0), narrow = pow(near_sun, 32.0);
    vec3 colour = mix(zenith, horizon, low) + sun_glow * (0.35 * wide * low + 0.5 * narrow);
    // Below the horizon the sky is what far things fade into.
    return mix(colour, fog_colour, clamp(-6.0 * d.y, 0.0, 1.0));
}

void main() {
    vec2 at = corner();
    vec3 light = sky(normalize(forward + at.x * right + at.y * up));
#ifdef HDR
    shade = light;
#else
    shade = tone_mapped(light);
#endif
    gl_Position = vec4(at, 1.0, 1.0);
}
