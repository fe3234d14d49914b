#version 330 core
// Soft, transparent meshes. The tint is their light; `glow` is the largest share of the background that they
// hide. LINEAR leaves the tone curve to the last pass.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in mat4 model;
layout(location = 7) in vec4 tint_glow;

uniform mat4 view_projection;
uniform vec3 eye;

out vec3 to_eye;
out vec3 normal_there;
flat out vec4 mist;

vec3 tone_mapped(vec3 light);

void main() {
    vec4 there = model * vec4(position, 1.0);
    to_eye = eye - there.xyz;
    normal_there = mat3(model) * normal;
#ifdef LINEAR
    // In front of a dark background the same share of light looks like more.
    mist = vec4(tint_glow.rgb, 0.45 * tint_glow.a);
#else
    mist = vec4(tone_mapped(tint_glow.rgb), tint_glow.a);
#endif
    gl_Position = view_projection * there;
}
