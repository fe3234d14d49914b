#version 330 core
// Share of the sun that reaches a place, by the shadow map. The map's hardware filter compares and blends
// four texels. SOFT averages nine such lookups (percentage-closer filtering, Reeves et al. 1987).
uniform sampler2DShadow shadow_map;
#ifdef SOFT
uniform float shadow_texel;
#endif

float sun_share(vec3 in_map) {
#ifdef SOFT
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            sum += texture(shadow_map, in_map + vec3(1.4 * shadow_texel * vec2(x, y), 0.0));
        }
    }
    return sum / 9.0;
#else
    return texture(shadow_map, in_map);
#endif
}
