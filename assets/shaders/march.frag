#version 330 core
// A volume seen along a ray, front to back. Each step adds the light at its place, reduced by the absorption
// in front of it. LINEAR leaves the tone curve to the last pass. The texels are as large as a hand, and the
// only sharp edges are those of things in the volume. So this shader draws fewer pixels than the view has.
in vec3 way;
#ifndef INSIDE
in vec3 bend;
in vec4 over;
in float gain;
in float foam_here;
in vec3 foam_light;
#endif

uniform sampler3D texels;
uniform sampler2D opaque;  // depth of the things in the volume
uniform vec3 eye;
uniform vec3 forward;
uniform vec2 depth_range;  // 1/m: a depth d is 1 / (x - y d) m ahead
uniform vec3 origin;
uniform vec3 inverse_size;
uniform vec3 centre;
uniform vec3 inverse_radii;
uniform float brightness;
uniform float thickness;  // absorption (1/m)
uniform int steps;
uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2

out vec4 pixel;  // colour premultiplied by alpha

vec3 tone_mapped(vec3 light);

// End of the ray at the ellipsoid, as a multiple of `ray`.
float round_end(vec3 from, vec3 ray) {
    vec3 start = (from - centre) * inverse_radii, along = ray * inverse_radii;
    float a = dot(along, along), b = dot(start, along), c = dot(start, start) - 1.0;
    return (sqrt(max(b * b - a * c, 0.0)) - b) / a;
}

// Light along the whole ray, and the share of the background that is hidden.
vec4 marched(vec3 from, vec3 ray) {
    vec3 start = (from - origin) * inverse_size, through = ray * inverse_size;
    // Computes e^(-x) as exp2(-x / ln 2). Steps grow with the square of their number, because near parts hide
    // far ones.
    float rate = 1.442695 * 2.0 * thickness * length(ray) / float(steps);
    vec3 light = vec3(0.0);
    float clear = 1.0;
    for (int i = 0; i < steps; ++i) {
        float u = (float(i) + 0.5) / float(steps);
        vec4 texel = texture(texels, start + u * u * through);
        float left = clear * exp2(-rate * u * texel.a);
        light += (clear - left) * (texel.rgb * texel.rgb);
        clear = left;
        if (clear < 0.02) break;
    }
    return vec4(brightness * light, 1.0 - clear);
}

#ifndef INSIDE
// Pattern of bubbles a few centimetres wide; more foam shows more of them.
float bubbles(vec2 p) {
    vec2 q = p * 34.0 + 1.9 * sin(p.yx * 17.0);
    return 0.5 + 0.25 * (sin(q.x) * sin(q.y) + sin(1.7 * q.x + q.y) * sin(1.3 * q.y - q.x));
}
#endif

void main() {
    float stop = 1.0 / (depth_range.x - depth_range.y * texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r);
#ifdef INSIDE
    float end = min(round_end(eye, way), stop);
    // The volume ends at the level.
    if (way.y > 0.0) end = min(end, max((centre.y - eye.y) / way.y, 0.0));
    vec4 seen = marched(eye, end * way);
#else
    float begin = dot(way, forward);
    vec3 from = eye + way, ray = (way + bend * length(way)) / begin;
    float end = max(round_end(from, ray), 0.0);
    // Things in front of the skin hide the volume anyway. Cutting the ray there would leave a hole that
    // spreads to pixels around.
    if (stop > begin) end = min(end, stop - begin);
    vec4 below = marched(from, end * ray);
    vec4 seen = vec4(over.rgb + (1.0 - over.a) * gain * below.rgb, over.a + (1.0 - over.a) * below.a);
    if (foam_here > 0.01) {
        float foam = 0.85 * smoothstep(0.0, 0.3, foam_here - bubbles(from.xz));
        // The brew lights the foam from below as well.
        seen = mix(seen, vec4(foam_light + 0.35 * below.rgb, 1.0), foam);
    }
    seen.rgb = mix(fog_colour * seen.a, seen.rgb, exp2(-fog_rate * dot(way, way)));
#endif
#ifdef LINEAR
    pixel = seen;
#else
    pixel = vec4(tone_mapped(seen.rgb / max(seen.a, 1e-3)) * seen.a, seen.a);
#endif
}
