#version 330 core
// Mist: densest where the surface faces the eye, and transparent at the outline, so that no edge is seen.
in vec3 to_eye;
in vec3 normal_there;
flat in vec4 mist;

out vec4 pixel;

void main() {
    float facing = max(dot(normalize(normal_there), normalize(to_eye)), 0.0);
    pixel = vec4(mist.rgb, mist.a * facing * facing);
}
