#version 330 core
// Variants as in mesh.vert; HDR leaves the tone curve to the last pass.
in vec3 from_eye;
#ifdef PER_PIXEL
in vec3 normal_there;
in vec3 surface;
in vec3 emitted;
in float open_sky;
uniform vec3 eye;
vec3 light_at(vec3 place, vec3 n, float open);
#else
in vec3 radiance;
#endif
#ifdef SHADOW
in vec3 sunlight;
in vec3 in_map;
float sun_share(vec3 in_map);
#endif

uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2

out vec4 pixel;

vec3 tone_mapped(vec3 light);

void main() {
#ifdef PER_PIXEL
    vec3 light = emitted + surface * light_at(eye + from_eye, normalize(normal_there), open_sky);
#else
    vec3 light = radiance;
#endif
#ifdef SHADOW
    light += sunlight * sun_share(in_map);
#endif
    float clear = exp2(-fog_rate * dot(from_eye, from_eye));
    light = mix(fog_colour, light, clear);
#ifdef HDR
    pixel = vec4(light, 1.0);
#else
    pixel = vec4(tone_mapped(light), 1.0);
#endif
}
