#version 460
// Adds a run's mean, and its square, to the sums over runs.
layout(set = 0, binding = 0) uniform sampler2D run;
layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 squares;

void main() {
  sum = vec4(texelFetch(run, ivec2(gl_FragCoord.xy), 0).rgb, 0.0);
  squares = sum * sum;
}
