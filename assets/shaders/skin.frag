#version 330 core
// Shows what was marched.
uniform sampler2D picture;
uniform vec4 to_picture;  // from pixels of the view's target to it: factor, shift

out vec4 pixel;

void main() { pixel = texture(picture, gl_FragCoord.xy * to_picture.xy + to_picture.zw); }
