#version 330 core
// A translucent scan seen along a ray, front to back. The table gives the colour and the absorption of each
// density. The samples of all rays lie at the same multiples of one length, whether or not a ray leaps.
//   LIT      the gradient of the density takes the light of sky and sun
//   PAINTED  each sample has a colour and a material
in vec3 way;
in vec3 ray;

uniform sampler1D table;  // rgb: colour; a: absorption (1/m, own frame)
#ifdef PAINTED
uniform sampler3D paint;
uniform sampler1D material_table;  // rgb: factor of the colour; a: factor of the absorption
#endif
uniform vec3 last;
uniform vec3 start;
uniform vec3 spacing;
uniform float nearest;
uniform float step_length;  // sample distances
#ifdef LIT
uniform mat3 to_samples;
uniform vec3 ambient_above;
uniform vec3 ambient_below;
uniform vec3 sun_direction;
uniform vec3 sun_colour;
uniform float sun;
#endif
uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2
uniform bool linear;     // true: the last pass applies the tone curve

out vec4 pixel;  // colour premultiplied by alpha

vec3 tone_mapped(vec3 light);
vec3 without_zeros(vec3 ray);
vec2 box_range(vec3 inverse);
float opaque_distance(vec2 pixel);
float density_at(vec3 place);
ivec3 brick_at(vec3 place);
float empty_around(ivec3 at);
float leaving(vec3 place, vec3 inverse, ivec3 at, float away);

// Share of the light that may still arrive when a ray ends: less than a step of an 8-bit colour.
const float least_clear = 1.0 / 600.0;

vec4 matter_at(vec3 place, float d) {
    vec4 matter = texture(table, (d * 255.0 + 0.5) / 256.0);
#ifdef PAINTED
    float index = texelFetch(paint, ivec3(place + 0.5), 0).a;
    vec4 material = texelFetch(material_table, int(index * 255.0 + 0.5), 0);
    vec3 shade = texture(paint, (place + 0.5) / (last + 1.0)).rgb;
    matter *= vec4(material.rgb * shade * shade, material.a);
#endif
    return matter;
}

#ifdef LIT
vec3 light_on(vec3 place, float d) {
    vec3 slope = vec3(density_at(place + vec3(1.0, 0.0, 0.0)), density_at(place + vec3(0.0, 1.0, 0.0)),
                      density_at(place + vec3(0.0, 0.0, 1.0))) - d;
    vec3 out_of = -(slope * to_samples);
    float steep = dot(out_of, out_of);
    vec3 n = out_of * inversesqrt(steep + 1e-12);
    if (dot(n, way) > 0.0) n = -n;
    return mix(ambient_below, ambient_above, 0.5 + 0.5 * n.y) +
           sun_colour * (sun * max(dot(n, sun_direction), 0.0));
}
#endif

void main() {
    vec3 along = without_zeros(ray), inverse = 1.0 / along;
    vec2 range = box_range(inverse);
    float begin = max(range.x, nearest), end = min(range.y, opaque_distance(gl_FragCoord.xy));
    float h = step_length / length(along);  // step of t
    // Absorbs as exp2(-rate a): e^(-a l) over the length l of a step in the own frame.
    float rate = 1.442695 * h * length(along * spacing);
    // Rays start at the box, so that numbers stay small.
    vec3 from = start + begin * along;
    float steps = end > begin ? (end - begin) / h : 0.0;
    float stop = ceil(steps);
    vec3 light = vec3(0.0);
    float clear = 1.0;
    for (float i = 0.0; i < stop;) {
        ivec3 at;
        for (; i < stop;) {
            vec3 place = from + ((i + 0.5) * h) * along;
            at = brick_at(place);
            float away = empty_around(at);
            if (away < 0.5) break;
            i = max(i + 1.0, ceil(leaving(from, inverse, at, away - 1.0) / h - 0.5));
        }
        // Ends after the brick's last sample.
        float last_here = min(stop, max(i + 1.0, ceil(leaving(from, inverse, at, 0.0) / h - 0.5)));
        for (; i < last_here; i += 1.0) {
            float share = min(steps - i, 1.0);  // the last step is shorter
            vec3 place = from + ((i + 0.5 * share) * h) * along;
            float d = density_at(place);
            vec4 matter = matter_at(place, d);
#ifdef LIT
            matter.rgb *= light_on(place, d);
#endif
            float left = clear * exp2(-rate * share * matter.a);
            light += (clear - left) * matter.rgb;
            clear = left;
            if (clear < least_clear) {
                i = stop;
                break;
            }
        }
    }
    if (clear < least_clear) {
        light /= 1.0 - clear;
        clear = 0.0;
    }
    vec4 seen = vec4(light, 1.0 - clear);
    float fogless = exp2(-fog_rate * begin * begin * dot(way, way));
    seen.rgb = mix(fog_colour * seen.a, seen.rgb, fogless);
    pixel = linear ? seen : vec4(tone_mapped(seen.rgb / max(seen.a, 1e-3)) * seen.a, seen.a);
}
