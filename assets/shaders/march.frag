#version 330 core
// What is seen of a volume along a ray, front to back: at each step the light that is given there, less what was swallowed
// before. LINEAR leaves the tone curve to the last pass. With texels the size of a hand and no edges but those of what
// stands in it, this is drawn with fewer pixels than the view.
in vec3 way;
#ifndef INSIDE
in vec3 bend;
in vec4 over;
in float gain;
in float foam_here;
in vec3 foam_light;
#endif

uniform sampler3D texels;
uniform sampler2D opaque;  // depth of what stands in it
uniform vec3 eye;
uniform vec3 forward;
uniform vec2 depth_range;  // 1/m: a depth d lies 1 / (x - y d) m ahead
uniform vec3 origin;
uniform vec3 inverse_size;
uniform vec3 centre;
uniform vec3 inverse_radii;
uniform float brightness;
uniform float thickness;  // 1/m
uniform int steps;
uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2

out vec4 pixel;  // premultiplied

vec3 tone_mapped(vec3 light);

// Where the ray leaves the round, as a multiple of it.
float round_end(vec3 from, vec3 ray) {
    vec3 start = (from - centre) * inverse_radii, along = ray * inverse_radii;
    float a = dot(along, along), b = dot(start, along), c = dot(start, start) - 1.0;
    return (sqrt(max(b * b - a * c, 0.0)) - b) / a;
}

// Light, and how much of what is behind is hidden, along all of a ray.
vec4 marched(vec3 from, vec3 ray) {
    vec3 start = (from - origin) * inverse_size, through = ray * inverse_size;
    // exp2(-x) for e^(-x). Steps grow with the square of their number: what is near hides what is far.
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
// Bubbles a few centimetres wide: more of them are there the more foam there is.
float bubbles(vec2 p) {
    vec2 q = p * 34.0 + 1.9 * sin(p.yx * 17.0);
    return 0.5 + 0.25 * (sin(q.x) * sin(q.y) + sin(1.7 * q.x + q.y) * sin(1.3 * q.y - q.x));
}
#endif

void main() {
    float stop = 1.0 / (depth_range.x - depth_range.y * texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r);
#ifdef INSIDE
    float end = min(round_end(eye, way), stop);
    // Above the level there is none.
    if (way.y > 0.0) end = min(end, max((centre.y - eye.y) / way.y, 0.0));
    vec4 seen = marched(eye, end * way);
#else
    float begin = dot(way, forward);
    vec3 from = eye + way, ray = (way + bend * length(way)) / begin;
    float end = max(round_end(from, ray), 0.0);
    // What stands before the skin hides it anyway; here it would only cut a hole that spreads to the pixels around.
    if (stop > begin) end = min(end, stop - begin);
    vec4 below = marched(from, end * ray);
    vec4 seen = vec4(over.rgb + (1.0 - over.a) * gain * below.rgb, over.a + (1.0 - over.a) * below.a);
    if (foam_here > 0.01) {
        float foam = 0.85 * smoothstep(0.0, 0.3, foam_here - bubbles(from.xz));
        // It is lit from below as well.
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
