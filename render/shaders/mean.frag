#version 460
// Adds the mean over runs to the picture.
layout(push_constant) uniform Push { float share; } push;
layout(set = 0, binding = 0) uniform sampler2D sum;
layout(location = 0) out vec4 color;

void main() { color = vec4(texelFetch(sum, ivec2(gl_FragCoord.xy), 0).rgb * push.share, 0.0); }
