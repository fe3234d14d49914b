#version 330 core
// The surface of one density in a scan. A ray visits cell after cell between eight samples. Where the samples
// lie on both sides of the level, the density along the ray is a cubic, whose first root is the hit (Parker
// et al. 1998, "Interactive ray tracing for isosurface rendering"; roots bracketed as in Marmitt et al. 2004,
// "Fast and accurate ray-voxel intersection techniques").
in vec3 way;
in vec3 ray;

uniform sampler3D density;
uniform sampler3D paint;
uniform sampler1D material_table;  // rgb: factor of the colour; a: below 0.5 the surface is invisible
uniform vec2 depth_range;
uniform vec3 start;
uniform vec3 last;
uniform vec3 eye;
uniform mat3 to_samples;
uniform float nearest;
uniform float level;
uniform vec3 colour;
uniform bool painted;
uniform bool behind_things;  // false: the ray goes on behind the scene
uniform vec3 sun_direction;
uniform vec3 sun_colour;
uniform float sun;
uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2
uniform bool linear;     // true: the last pass applies the tone curve

out vec4 pixel;

vec3 tone_mapped(vec3 light);
vec3 light_at(vec3 place, vec3 n, float open);
vec3 without_zeros(vec3 ray);
vec2 box_range(vec3 inverse);
float opaque_distance(vec2 pixel);
float density_at(vec3 place);
float empty_around(ivec3 at);
float leaving(vec3 place, vec3 inverse, ivec3 at, float away);

// Roots this far outside a cell count, so that no ray slips between two cells (sample distances).
const float tolerance = 1e-3;

float sample_at(ivec3 at) { return texelFetch(density, at, 0).r; }

// Coefficients of the density less the level along a + s b in a cell, s^0 first.
vec4 cubic(vec4 low, vec4 high, vec3 a, vec3 b) {
    // Powers of x, y, z: 1, x, y, xy of both layers, from corners 000 100 010 110.
    vec4 k = vec4(low.x, low.y - low.x, low.z - low.x, low.w - low.z - low.y + low.x);
    vec4 m = vec4(high.x, high.y - high.x, high.z - high.x, high.w - high.z - high.y + high.x) - k;
    float axay = a.x * a.y, mixed = a.x * b.y + a.y * b.x, bxby = b.x * b.y;
    vec3 in_low = vec3(k.x + k.y * a.x + k.z * a.y + k.w * axay, k.y * b.x + k.z * b.y + k.w * mixed,
                       k.w * bxby);
    vec3 rise = vec3(m.x + m.y * a.x + m.z * a.y + m.w * axay, m.y * b.x + m.z * b.y + m.w * mixed,
                     m.w * bxby);
    return vec4(in_low.x - level + a.z * rise.x, in_low.y + a.z * rise.y + b.z * rise.x,
                in_low.z + a.z * rise.z + b.z * rise.y, b.z * rise.z);
}

float value(vec4 c, float s) { return c.x + s * (c.y + s * (c.z + s * c.w)); }

// First root in [-slack, 1 + slack]; below -slack if there is none.
float first_root(vec4 c, float slack) {
    // Between the extrema of the cubic each part is monotone.
    float a = 3.0 * c.w, b = c.z, d = b * b - a * c.y;
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(d, 0.0)));
    float e0 = abs(a) > 1e-12 ? q / a : 2.0, e1 = abs(q) > 1e-12 ? c.y / q : 2.0;
    if (d < 0.0) e0 = e1 = 2.0;
    float from = -slack, to = 1.0 + slack;
    float first = clamp(min(e0, e1), from, to), second = clamp(max(e0, e1), from, to);
    float f0 = value(c, from), f1 = value(c, first), f2 = value(c, second), f3 = value(c, to);
    if (f0 * f1 <= 0.0) {
        to = first;
        f3 = f1;
    } else if (f1 * f2 <= 0.0) {
        from = first;
        f0 = f1;
        to = second;
        f3 = f2;
    } else {
        from = second;
        f0 = f2;
    }
    if (f0 * f3 > 0.0) return -2.0 * slack - 1.0;
    // Regula falsi that halves the weight of an end that stays (the Illinois method).
    float root = from;
    for (int i = 0; i < 8; ++i) {
        float denominator = f3 - f0;
        root = abs(denominator) > 1e-20 ? (from * f3 - to * f0) / denominator : 0.5 * (from + to);
        float f = value(c, root);
        if (f * f3 <= 0.0) {
            from = to;
            f0 = f3;
        } else {
            f0 *= 0.5;
        }
        to = root;
        f3 = f;
    }
    return root;
}

// Gradient at a place (per sample distance). At the faces the difference is one-sided.
vec3 slope_at(vec3 place) {
    vec3 low = max(place - 1.0, 0.0), high = min(place + 1.0, last);
    return vec3(density_at(vec3(high.x, place.yz)) - density_at(vec3(low.x, place.yz)),
                density_at(vec3(place.x, high.y, place.z)) - density_at(vec3(place.x, low.y, place.z)),
                density_at(vec3(place.xy, high.z)) - density_at(vec3(place.xy, low.z))) / (high - low);
}

bool visible(vec3 place) {
    if (!painted) return true;
    float index = texelFetch(paint, ivec3(place + 0.5), 0).a;
    return texelFetch(material_table, int(index * 255.0 + 0.5), 0).a >= 0.5;
}

vec3 surface_colour(vec3 place) {
    if (!painted) return colour;
    float index = texelFetch(paint, ivec3(place + 0.5), 0).a;
    vec3 shade = texture(paint, (place + 0.5) / (last + 1.0)).rgb;
    return colour * texelFetch(material_table, int(index * 255.0 + 0.5), 0).rgb * shade * shade;
}

// Distance to the hit from `from`, at most `end`; negative if there is none. `inside`: the ray begins in
// matter.
float hit(vec3 from, vec3 along, vec3 inverse, float end, out bool inside) {
    ivec3 highest = ivec3(last) - 1, direction = ivec3(sign(along));
    vec3 ahead = max(vec3(direction), 0.0);
    ivec3 cell = clamp(ivec3(floor(from)), ivec3(0), highest);
    inside = density_at(from) >= level && visible(from);
    if (inside) return 0.0;
    float t = 0.0, found = -1.0;
    int left = 3 * (highest.x + highest.y + highest.z) + 64;  // guards against numbers that are not finite
    while (t < end && found < 0.0 && left > 0) {
        ivec3 at;
        for (; t < end && left > 0; --left) {
            at = cell / 8;
            float away = empty_around(at);
            if (away < 0.5) break;
            float next = leaving(from, inverse, at, away - 1.0);
            // A little further, so that rounding does not return to the same cell.
            t = max(next, t) + 1e-4 * min(min(abs(inverse.x), abs(inverse.y)), abs(inverse.z));
            cell = clamp(ivec3(floor(from + t * along)), ivec3(0), highest);
        }
        vec3 to = (vec3(cell) + ahead - from) * inverse;
        vec4 low = vec4(0.0), high = vec4(0.0);
        float leave = t;
        bool candidate = false;
        for (; t < end && left > 0; --left) {
            low = vec4(sample_at(cell), sample_at(cell + ivec3(1, 0, 0)), sample_at(cell + ivec3(0, 1, 0)),
                       sample_at(cell + ivec3(1, 1, 0)));
            high = vec4(sample_at(cell + ivec3(0, 0, 1)), sample_at(cell + ivec3(1, 0, 1)),
                        sample_at(cell + ivec3(0, 1, 1)), sample_at(cell + ivec3(1, 1, 1)));
            vec4 most = max(low, high), least = min(low, high);
            leave = min(min(to.x, to.y), to.z);
            candidate = max(max(most.x, most.y), max(most.z, most.w)) >= level &&
                        min(min(least.x, least.y), min(least.z, least.w)) <= level;
            if (candidate) break;
            bvec3 through = lessThanEqual(to, vec3(leave));
            cell += ivec3(through) * direction;
            to += vec3(through) * abs(inverse);
            t = leave;
            if (any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, highest))) t = end;
            if (any(notEqual(cell / 8, at))) break;
        }
        if (candidate && t < end) {
            float length_here = max(leave - t, 1e-9);
            vec3 through_cell = length_here * along;
            float slack = min(tolerance / length(through_cell), 1e4);
            float s = first_root(cubic(low, high, from + t * along - vec3(cell), through_cell), slack);
            float there = t + s * length_here;
            if (s >= -slack && there <= end && visible(from + there * along)) found = max(there, 0.0);
            bvec3 through = lessThanEqual(to, vec3(leave));
            cell += ivec3(through) * direction;
            t = leave;
            if (any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, highest))) t = end;
        }
        --left;
    }
    return found;
}

void main() {
    vec3 along = without_zeros(ray), inverse = 1.0 / along;
    vec2 range = box_range(inverse);
    float begin = max(range.x, nearest), end = range.y;
    if (behind_things) end = min(end, opaque_distance(gl_FragCoord.xy));
    vec3 from = start + begin * along;
    bool inside = false;
    float way_there = -1.0;
    if (end > begin) way_there = hit(from, along, inverse, end - begin, inside);
    if (way_there < 0.0) discard;
    float t = begin + way_there;
    vec3 place = clamp(from + way_there * along, vec3(0.0), last);
    vec3 n = -(slope_at(place) * to_samples);
    if (inside) {
        // A cut through matter at a face of the scan has the normal of the face.
        vec3 face = vec3(0.0);
        vec3 depth = min(abs(from), abs(last - from));
        if (depth.x <= min(depth.y, depth.z)) face.x = 1.0;
        else if (depth.y <= depth.z) face.y = 1.0;
        else face.z = 1.0;
        n = face * to_samples;
    }
    n *= inversesqrt(max(dot(n, n), 1e-30));
    if (dot(n, way) > 0.0) n = -n;
    vec3 light = surface_colour(place) * (light_at(eye + t * way, n, 1.0) +
                                          sun_colour * (sun * max(dot(n, sun_direction), 0.0)));
    light = mix(fog_colour, light, exp2(-fog_rate * t * t * dot(way, way)));
    pixel = vec4(linear ? light : tone_mapped(light), 1.0);
    gl_FragDepth = (depth_range.x - 1.0 / t) / depth_range.y;
}
