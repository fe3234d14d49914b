#version 330 core
// Share of the sun that reaches a place, by the shadow map. The map's hardware filter compares and blends
// four texels. SOFT averages four such lookups (percentage-closer filtering, Reeves et al. 1987).
uniform sampler2DShadow shadow_map;
#ifdef SOFT
uniform float shadow_texel;
#endif

float sun_share(vec3 in_map) {
#ifdef SOFT
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 beside = vec2(2.0 * float(i & 1) - 1.0, float(i & 2) - 1.0);
        sum += texture(shadow_map, in_map + vec3(shadow_texel * beside, 0.0));
    }
    return 0.25 * sum;
#else
    return texture(shadow_map, in_map);
#endif
}
