#version 330 core
// Light at a surface from everywhere but the sun: hemisphere ambient, where the sky is open, and point lights. Linear.
uniform vec3 ambient_above;
uniform vec3 ambient_below;
// What there are fewer of is black.
uniform vec4 light_position[8];  // w: 1 / radius^2
uniform vec3 light_colour[8];

// As many as that for certain: up to a number that is known only as it draws, a software rasteriser takes each light for
// each vertex by itself, and those beyond it too.
#ifdef FEW_LIGHTS
const int lights = 4;
#else
const int lights = 8;
#endif

// Inverse square close by, and exactly 0 at the radius.
float falloff(float square) {
    float window = max(1.0 - square * square, 0.0);
    return window * window / (1.0 + 12.0 * square);
}

vec3 light_at(vec3 place, vec3 n, float open) {
    vec3 light = mix(ambient_below, ambient_above, 0.5 + 0.5 * n.y) * open;
    for (int i = 0; i < lights; ++i) {
        vec3 to = light_position[i].xyz - place;
        float square = dot(to, to);
        // Some of the light wraps around, so that low-poly shapes do not turn black at one edge.
        float facing = max(0.7 * dot(n, to) * inversesqrt(square + 1e-6) + 0.3, 0.0);
        light += light_colour[i] * (facing * falloff(square * light_position[i].w));
    }
    return light;
}
