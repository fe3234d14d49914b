#version 330 core
// Parts of a ray through a scan. A place is given in sample distances from the first sample, a distance t as
// a multiple of the ray, which is 1 m ahead of the eye.
uniform sampler3D density;
uniform sampler3D bricks;   // distance to the nearest brick that shows something, in bricks / 255
uniform sampler2D opaque;   // depth of the scene
uniform vec4 to_opaque;     // from this target's pixels to those of `opaque`: xy factor, zw shift
uniform vec2 depth_range;   // 1/m: a depth d is 1 / (x - y d) m ahead
uniform vec3 start;         // the eye
uniform vec3 last;          // the last sample
uniform float nearest;      // distance of the near plane (m)
uniform float leaps;        // 0: no leaps; 1

const float brick = 8.0;

// No component is 0, so that every plane is met somewhere.
vec3 without_zeros(vec3 ray) {
    vec3 least = vec3(1e-7 * length(ray));
    return mix(ray, mix(-least, least, greaterThanEqual(ray, vec3(0.0))), lessThan(abs(ray), least));
}

// Where the ray enters and leaves the box of samples.
vec2 box_range(vec3 inverse) {
    vec3 a = -start * inverse, b = (last - start) * inverse;
    vec3 low = min(a, b), high = max(a, b);
    return vec2(max(max(low.x, low.y), low.z), min(min(high.x, high.y), high.z));
}

float opaque_distance(vec2 pixel) {
    vec2 at = pixel * to_opaque.xy + to_opaque.zw;
    return 1.0 / (depth_range.x - depth_range.y * texelFetch(opaque, ivec2(at), 0).r);
}

float density_at(vec3 place) { return texture(density, (place + 0.5) / (last + 1.0)).r; }

ivec3 brick_at(vec3 place) { return ivec3(clamp(place, vec3(0.0), last - 0.01) / brick); }

// Bricks to the nearest one that shows something; 0 if this one does.
float empty_around(ivec3 at) { return floor(255.0 * leaps * texelFetch(bricks, at, 0).r + 0.5); }

// Distance from `place` to the end of the bricks around `at`, `away` of them to each side.
float leaving(vec3 place, vec3 inverse, ivec3 at, float away) {
    vec3 low = brick * (vec3(at) - away), high = low + brick * (2.0 * away + 1.0);
    vec3 to = (mix(low, high, greaterThan(inverse, vec3(0.0))) - place) * inverse;
    return min(min(to.x, to.y), to.z);
}
