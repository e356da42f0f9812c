// The picture of the environment and the distributions for sampling its directions: render/light/light_map.h.
layout(set = 2, binding = 0) uniform sampler2D light_texels;   // rgb: radiance, a: density per solid angle
layout(set = 2, binding = 3) uniform sampler2D light_blurred;  // all levels: render/light/blurred_light.h
const float kPi = 3.14159265358979;

vec3 to_picture(vec3 w) {
  const vec4 e = frame.environment;
  return vec3(e.x * w.x - e.y * w.z, w.y, e.y * w.x + e.x * w.z);
}
vec3 from_picture(vec3 w) {
  const vec4 e = frame.environment;
  return vec3(e.x * w.x + e.y * w.z, w.y, e.x * w.z - e.y * w.x);
}

// The share of the environment's radiance from the direction w (in the world) that reaches the point p: below the horizon,
// the light that reaches the floor next to the objects, which are taken as balls. render/scene/floor.h is the same.
float floor_share(vec3 p, vec3 w) {
  const float floor_height = frame.environment.w;
  if (w.y >= 0.0 || floor_height <= kNoFloor) return 1.0;
  const vec3 place = p + w * (max(p.y - floor_height, 0.0) / max(-w.y, 1e-4));
  float share = 1.0;
  for (int k = 0; k < int(frame.shadow.z); ++k) {
    const vec3 centre = items[k].model[3].xyz;
    const vec2 apart = place.xz - centre.xz;
    const float radius = items[k].weights[2].a;
    share *= light_beside_ball(max(centre.y - floor_height, radius), radius, dot(apart, apart));
  }
  return share;
}
