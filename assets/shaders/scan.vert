#version 330 core
// Rays of the eye over the whole view, in the world and between the samples of a scan.
uniform vec3 forward;
uniform vec3 right;
uniform vec3 up;
uniform mat3 to_samples;

out vec3 way;  // ray from the eye; 1 m ahead
out vec3 ray;  // the same, in sample distances along each axis

void main() {
    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    way = forward + at.x * right + at.y * up;
    ray = to_samples * way;
    gl_Position = vec4(at, 0.0, 1.0);
}
