#version 330 core
// Light at a surface from all sources but the sun: hemisphere ambient under the open sky, and point lights.
// Linear colours.
uniform vec3 ambient_above;
uniform vec3 ambient_below;
// Point lights; unused ones are black.
uniform vec4 light_position[8];  // xyz: position (m, world); w: 1 / radius^2
uniform vec3 light_colour[8];

// Fixed number of lights. With a number known only while drawing, a software rasteriser computes each light
// for each vertex one at a time, and the unused lights too.
#ifdef FEW_LIGHTS
const int lights = 4;
#else
const int lights = 8;
#endif

// Inverse square near the light, and exactly 0 at its radius.
float falloff(float square) {
    float window = max(1.0 - square * square, 0.0);
    return window * window / (1.0 + 12.0 * square);
}

vec3 light_at(vec3 place, vec3 n, float open) {
    vec3 light = mix(ambient_below, ambient_above, 0.5 + 0.5 * n.y) * open;
    for (int i = 0; i < lights; ++i) {
        vec3 to = light_position[i].xyz - place;
        float square = dot(to, to);
        // Lets some light wrap around, so that low-poly shapes do not turn black at one edge.
        float facing = max(0.7 * dot(n, to) * inversesqrt(square + 1e-6) + 0.3, 0.0);
        light += light_colour[i] * (facing * falloff(square * light_position[i].w));
    }
    return light;
}
