#version 330 core
// The sky at the far end of the depth range, as a grid over the view. Its colour is so smooth that it is
// computed and tone mapped at 17 x 11 corners and not at each pixel. A software rasteriser would compute a
// million pixels. LINEAR leaves the tone curve to the last pass.
uniform vec3 forward;
uniform vec3 right;
uniform vec3 up;
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 sun_direction;
uniform vec3 sun_glow;
uniform vec3 fog_colour;
uniform bool cleared_to_fog;  // true: uncovered pixels already have the fog's colour

out vec3 shade;

vec3 tone_mapped(vec3 light);

const ivec2 cells = ivec2(16, 10);
const float all_fog = -1.0 / 6.0;  // y of the unit direction at which the sky ends

ivec2 cell_of() {
    int cell = gl_VertexID / 6;
    return ivec2(cell % cells.x, cell / cells.x);
}

// Two triangles: corners 0 1 2 and 2 1 3 of the cell.
int corner_of_cell() {
    int k = gl_VertexID % 6;
    return k < 3 ? k : (k == 3 ? 2 : (k == 4 ? 1 : 3));
}

vec2 corner(ivec2 cell, int i) { return 2.0 * vec2(cell + ivec2(i & 1, i >> 1)) / vec2(cells) - 1.0; }

vec3 sky(vec3 d) {
    float up_away = 1.0 - clamp(d.y, 0.0, 1.0);
    float low = up_away * up_away * up_away;
    float near_sun = max(dot(d, sun_direction), 0.0);
    float wide = pow(near_sun, 4.0), narrow = pow(near_sun, 32.0);
    vec3 colour = mix(zenith, horizon, low) + sun_glow * (0.35 * wide * low + 0.5 * narrow);
    // Below the horizon the sky fades to the fog that far things fade into.
    return mix(colour, fog_colour, clamp(d.y / all_fog, 0.0, 1.0));
}

vec3 towards(vec2 at) { return normalize(forward + at.x * right + at.y * up); }

void main() {
    ivec2 cell = cell_of();
    float highest = -1.0;
    for (int i = 0; i < 4; ++i) highest = max(highest, towards(corner(cell, i)).y);
    if (cleared_to_fog && highest < all_fog) {
        // The cell's pixels have the fog's colour already: the cell shrinks to a point.
        shade = vec3(0.0);
        gl_Position = vec4(0.0, 0.0, 1.0, 1.0);
        return;
    }
    vec2 at = corner(cell, corner_of_cell());
    vec3 light = sky(towards(at));
#ifdef LINEAR
    shade = light;
#else
    shade = tone_mapped(light);
#endif
    gl_Position = vec4(at, 1.0, 1.0);
}
