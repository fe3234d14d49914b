#version 330 core
// Starts of the rays into a volume: at its skin, with the light on that skin; or with INSIDE at the eye, over
// the whole view.
#ifdef INSIDE
uniform vec3 forward;
uniform vec3 right;
uniform vec3 up;

out vec3 way;  // ray from the eye; 1 m ahead

void main() {
    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    way = forward + at.x * right + at.y * up;
    gl_Position = vec4(at, 0.0, 1.0);
}
#else
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float foam;

uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 sun_direction;
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 foam_colour;

out vec3 way;         // vector from the eye
out vec3 bend;        // change of the ray's direction by refraction
out vec4 over;        // rgb: light reflected by the skin; a: share of the volume's light that it hides
out float gain;       // factor on the light from below
out float foam_here;  // share of foam (0 to 1)
out vec3 foam_light;

vec3 light_at(vec3 place, vec3 n, float open);

// Limit of the reflected share. At grazing angles the skin would be all mirror and show the sky instead of
// the brew.
const float most_mirrored = 0.3;
const float ripple_light = 5.0;
const float refraction = 0.8;

void main() {
    way = position - eye;
    vec3 looking = normalize(way);
    // Schlick's approximation for water.
    float away = 1.0 - clamp(-dot(normal, looking), 0.0, 1.0), away2 = away * away;
    float mirrored = min(0.02 + 0.98 * away2 * away2 * away, most_mirrored);
    vec3 seen = reflect(looking, normal);
    over = vec4(mix(horizon, zenith, clamp(seen.y, 0.0, 1.0)) * mirrored, mirrored);
    // Slopes towards the sun are lighter than slopes away from it.
    vec3 tilt = normal - vec3(0.0, 1.0, 0.0);
    gain = clamp(1.0 + ripple_light * dot(tilt, sun_direction), 0.5, 1.9);
    bend = -refraction * vec3(tilt.x, 0.0, tilt.z);
    foam_here = foam;
    foam_light = foam_colour * light_at(position, normal, 1.0);
    gl_Position = view_projection * vec4(position, 1.0);
}
#endif
