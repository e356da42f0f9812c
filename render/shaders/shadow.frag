#version 460
// How near to the light the surface is.
layout(location = 0) out float nearness;

void main() { nearness = gl_FragCoord.z; }
