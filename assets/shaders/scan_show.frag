#version 330 core
// Puts drawn scans over the view. Where the drawn picture has fewer pixels than the view, four of them give
// one. SOLID: surfaces with depth. Otherwise pixels that saw the scene at another depth than this one count
// little, so that a translucent scan keeps the sharp edge of a thing in it or before it.
uniform sampler2D picture;
#ifdef SOLID
uniform sampler2D drawn_depth;
#else
uniform sampler2D opaque;    // depth of the scene
uniform vec4 to_opaque;      // from this target's pixels to those of `opaque`: xy factor, zw shift
uniform vec2 depth_range;
#endif
uniform vec4 to_picture;     // from the view's pixels to those of `picture`: xy factor, zw shift
uniform ivec4 inside;        // lowest and highest pixel of the view in `picture`
uniform vec2 corner;         // of the view, in its target

out vec4 pixel;

#ifndef SOLID
float distance_at(vec2 at) {
    return 1.0 / (depth_range.x - depth_range.y * texelFetch(opaque, ivec2(at), 0).r);
}
#endif

void main() {
    vec2 here = gl_FragCoord.xy - corner;
    vec2 at = here * to_picture.xy + to_picture.zw;
    if (to_picture.x == 1.0 && to_picture.y == 1.0) {
        pixel = texelFetch(picture, ivec2(at), 0);
#ifdef SOLID
        if (pixel.a < 0.5) discard;
        gl_FragDepth = texelFetch(drawn_depth, ivec2(at), 0).r;
#endif
        return;
    }
    vec2 low = floor(at - 0.5), part = at - 0.5 - low;
    vec4 sum = vec4(0.0);
    float weights = 0.0;
#ifdef SOLID
    float best = 0.0, depth = 1.0;
#else
    float own = distance_at(here);
#endif
    for (int i = 0; i < 4; ++i) {
        vec2 side = vec2(i & 1, i >> 1);
        ivec2 from = clamp(ivec2(low + side), inside.xy, inside.zw);
        vec2 share = mix(1.0 - part, part, side);
        float weight = share.x * share.y;
        vec4 there = texelFetch(picture, from, 0);
#ifdef SOLID
        weight *= there.a;
        if (weight > best) {
            best = weight;
            depth = texelFetch(drawn_depth, from, 0).r;
        }
#else
        float other = distance_at((vec2(from) + 0.5) * to_opaque.xy + to_opaque.zw);
        weight = (weight + 1e-3) / (1e-3 + abs(other - own) / own);
#endif
        sum += weight * there;
        weights += weight;
    }
#ifdef SOLID
    if (weights < 0.5) discard;
    gl_FragDepth = depth;
#endif
    pixel = sum / max(weights, 1e-6);
}
