#version 330 core
// Meshes lit in each pixel. The last pass applies the tone curve. Without SHADOW: meshes that no sun reaches.
in vec3 from_eye;
in vec3 normal_there;
in vec3 surface;
in vec3 emitted;
in float open_sky;
#ifdef SHADOW
in vec3 sunlight;
in vec3 in_map;
#endif

uniform vec3 eye;
uniform vec3 fog_colour;
uniform float fog_rate;  // 1/m^2

out vec4 pixel;

vec3 light_at(vec3 place, vec3 n, float open);
#ifdef SHADOW
float sun_share(vec3 in_map);
#endif

void main() {
    vec3 light = emitted + surface * light_at(eye + from_eye, normalize(normal_there), open_sky);
#ifdef SHADOW
    light += sunlight * sun_share(in_map);
#endif
    float clear = exp2(-fog_rate * dot(from_eye, from_eye));
    pixel = vec4(mix(fog_colour, light, clear), 1.0);
}
