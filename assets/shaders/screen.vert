#version 330 core
// One triangle over the whole viewport.
uniform vec4 part = vec4(0.0, 0.0, 1.0, 1.0);  // part of the picture that is read: lower left corner, size

out vec2 at;      // position in the picture (0 to 1)
out vec2 within;  // position in the viewport (0 to 1)

void main() {
    within = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    at = part.xy + part.zw * within;
    gl_Position = vec4(2.0 * within - 1.0, 0.0, 1.0);
}
