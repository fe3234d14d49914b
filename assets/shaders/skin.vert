#version 330 core
// Area of the view that a volume's skin covers; with INSIDE the whole view.
#ifdef INSIDE
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
#else
layout(location = 0) in vec3 position;

uniform mat4 view_projection;

void main() { gl_Position = view_projection * vec4(position, 1.0); }
#endif
