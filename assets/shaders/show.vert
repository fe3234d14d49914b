#version 330 core
// A rectangle over the whole viewport, as two triangles: a software rasteriser knows it as a rectangle and
// copies or stretches a picture into it several times as fast as it runs a shader for each pixel.
uniform vec4 part = vec4(0.0, 0.0, 1.0, 1.0);  // part of the picture that is read: lower left corner, size

out vec2 at;  // position in the picture (0 to 1)

// Corners 0 1 2 and 2 1 3.
int corner() { return gl_VertexID < 3 ? gl_VertexID : (gl_VertexID == 3 ? 2 : (gl_VertexID == 4 ? 1 : 3)); }

void main() {
    vec2 within = vec2(corner() & 1, corner() >> 1);
    at = part.xy + part.zw * within;
    gl_Position = vec4(2.0 * within - 1.0, 0.0, 1.0);
}
