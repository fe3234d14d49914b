#version 330 core
// Copies the marched volume into the view.
uniform sampler2D picture;
uniform vec4 to_picture;  // from the view's pixels to the picture: xy factor, zw offset

out vec4 pixel;

void main() { pixel = texture(picture, gl_FragCoord.xy * to_picture.xy + to_picture.zw); }
