#version 460
// Shows a finished picture at another size, interpolated.
layout(push_constant) uniform Push {
  ivec2 origin;  // in the window, of what is shown
  ivec2 place;   // its size there
} push;
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(location = 0) out vec4 color;

void main() {
  color = vec4(textureLod(picture, (gl_FragCoord.xy - vec2(push.origin)) / vec2(push.place), 0.0).rgb, 1.0);
}
