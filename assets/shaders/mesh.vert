#version 330 core
// Meshes of the arena. Colours are linear. Variants:
//   PER_PIXEL  the fragment shader computes light, fog and tone curve. Without PER_PIXEL this shader computes
//              them for each vertex, so that a pixel costs almost nothing.
//   LINEAR     without PER_PIXEL: the last pass applies the tone curve.
//   SHADOW     the sun's light is kept apart, so that the shadow map can remove it.
//   ALONE      one instance. A software rasteriser would fetch instance attributes again for each vertex.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 8) in vec4 baked;   // rgb: light of the lamps that never change; a: openness of the sky
layout(location = 9) in vec2 detail;  // x: share of the sun; y: factor on the colour far away
#ifdef ALONE
uniform mat4 model;
uniform vec4 tint_glow;
uniform float instance_sun;
#else
layout(location = 3) in mat4 model;
layout(location = 7) in vec4 tint_glow;
layout(location = 10) in float instance_sun;
#endif

uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 sun_direction;
uniform vec3 sun_colour;
uniform vec2 detail_range;  // x: distance (m) where fine lines begin to fade; y: 1 / length of the fade

#ifdef PER_PIXEL
out vec3 from_eye;
out vec3 normal_there;
out vec3 surface;
out vec3 emitted;
out float open_sky;
#else
out vec3 shade;

uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2
vec3 tone_mapped(vec3 light);
#endif
#ifdef SHADOW
uniform mat4 shadow_matrix;  // from the world to the map's coordinates, all three in [0, 1]
uniform float shadow_lift;   // offset along the normal (m) against a surface's shadow on itself
out vec3 sunlight;
out vec3 in_map;
#endif

// Light of a full glow, as a multiple of the surface's colour.
const float glow_strength = 2.2;

vec3 light_at(vec3 place, vec3 n, float open);

void main() {
    vec4 world = model * vec4(position, 1.0);
    // The inverse transpose of a rotation times a scale divides each axis by its length squared.
    mat3 linear = mat3(model);
    vec3 stretch = vec3(dot(linear[0], linear[0]), dot(linear[1], linear[1]), dot(linear[2], linear[2]));
    vec3 n = normalize(linear * (normal / stretch));
#ifndef PER_PIXEL
    vec3 from_eye;
#endif
    from_eye = world.xyz - eye;
    gl_Position = view_projection * world;

    float far = clamp((length(from_eye) - detail_range.x) * detail_range.y, 0.0, 1.0);
    vec3 paint = colour * tint_glow.rgb * mix(1.0, detail.y, far);
    float matt = 1.0 - tint_glow.a;
    vec3 own = paint * (baked.rgb * matt + glow_strength * tint_glow.a);
    vec3 sun = paint * sun_colour * (max(dot(n, sun_direction), 0.0) * matt);
#ifdef PER_PIXEL
    normal_there = n;
    surface = paint * matt;
    emitted = own;
    open_sky = baked.a;
#ifdef SHADOW
    sunlight = sun;
#endif
#else
    vec3 radiance = own + paint * matt * light_at(world.xyz, n, baked.a);
    float clear = exp2(-fog_rate * dot(from_eye, from_eye));
#ifdef LINEAR
#ifdef SHADOW
    shade = mix(fog_colour, radiance, clear);
    sunlight = sun * clear;
#else
    shade = mix(fog_colour, radiance + sun * (detail.x * instance_sun), clear);
#endif
#elif defined(SHADOW)
    // Shade without and with the sun, both after the tone curve. The shadow map blends between the two.
    shade = tone_mapped(mix(fog_colour, radiance, clear));
    sunlight = tone_mapped(mix(fog_colour, radiance + sun, clear)) - shade;
#else
    shade = tone_mapped(mix(fog_colour, radiance + sun * (detail.x * instance_sun), clear));
#endif
#endif
#ifdef SHADOW
    in_map = (shadow_matrix * vec4(world.xyz + shadow_lift * n, 1.0)).xyz;
#endif
}
