#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "rules.glsl"
#include "light.glsl"
layout(location = 0) out vec4 color;

// The environment's picture behind the objects, interpolated: LightMap::shown.
void main() {
  const vec3 ray = normalize(ray_through(gl_FragCoord.xy)), w = to_picture(ray);
  const ivec2 size = textureSize(light_texels, 0);
  const vec2 place = vec2(atan(w.x, -w.z) / (2.0 * kPi) + 0.5, atan(length(w.xz), w.y) / kPi) * vec2(size) - 0.5;
  const vec2 low = floor(place), t = place - low;
  const int left = (int(low.x) + size.x) % size.x, right = (left + 1) % size.x;
  const int above = clamp(int(low.y), 0, size.y - 1), below = clamp(int(low.y) + 1, 0, size.y - 1);
  const vec3 upper = mix(texelFetch(light_texels, ivec2(left, above), 0).rgb,
                         texelFetch(light_texels, ivec2(right, above), 0).rgb, t.x);
  const vec3 lower = mix(texelFetch(light_texels, ivec2(left, below), 0).rgb,
                         texelFetch(light_texels, ivec2(right, below), 0).rgb, t.x);
  color = vec4(mix(upper, lower, t.y) * (frame.environment.z * floor_share(frame.camera.xyz, ray)), 0.0);
}
