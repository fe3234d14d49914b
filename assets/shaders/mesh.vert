#version 330 core
// Lights each vertex: sun, hemisphere ambient and point lights. Colours are linear.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in mat4 model;
layout(location = 7) in vec4 tint_glow;

uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 sun_direction;
uniform vec3 sun_colour;
uniform vec3 ambient_above;
uniform vec3 ambient_below;
uniform int light_count;
uniform vec4 light_position[8];  // w: 1 / radius^2
uniform vec3 light_colour[8];

out vec3 radiance;
out vec3 from_eye;

// What a full glow gives, as a multiple of the surface's colour.
const float glow_strength = 2.2;

// Inverse square close by, and exactly 0 at the radius.
float falloff(float square) {
    float window = max(1.0 - square * square, 0.0);
    return window * window / (1.0 + 12.0 * square);
}

void main() {
    vec4 world = model * vec4(position, 1.0);
    // The inverse transpose of a rotation times a scale divides each axis by its length squared.
    mat3 linear = mat3(model);
    vec3 stretch = vec3(dot(linear[0], linear[0]), dot(linear[1], linear[1]), dot(linear[2], linear[2]));
    vec3 n = normalize(linear * (normal / stretch));

    vec3 light = mix(ambient_below, ambient_above, 0.5 + 0.5 * n.y);
    light += sun_colour * max(dot(n, sun_direction), 0.0);
    for (int i = 0; i < light_count; ++i) {
        vec3 to = light_position[i].xyz - world.xyz;
        float square = dot(to, to);
        // Half of the light wraps around, so that low-poly shapes do not turn black at one edge.
        float facing = max(0.7 * dot(n, to) * inversesqrt(square + 1e-6) + 0.3, 0.0);
        light += light_colour[i] * (facing * falloff(square * light_position[i].w));
    }
    vec3 surface = colour * tint_glow.rgb;
    radiance = surface * mix(light, vec3(glow_strength), tint_glow.a);
    from_eye = world.xyz - eye;
    gl_Position = view_projection * world;
}
