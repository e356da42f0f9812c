#version 460
// How near to the light the surface is, and whose it is.
layout(push_constant) uniform Push { int item; } push;
layout(location = 0) out vec2 nearness_and_object;

void main() { nearness_and_object = vec2(gl_FragCoord.z, float(push.item)); }
