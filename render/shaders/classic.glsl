// The articles' shading modes (shaders/classic.vert, classic.frag): a renderer's own colours, no BRDF.
layout(constant_id = 0) const int kShading = 1;
layout(constant_id = 1) const bool kAsCoded = false;  // with the errors of the articles
layout(constant_id = 2) const bool kPerVertex = false;  // phong_blinn: colours, lookup: coordinates per vertex
const float kExponent = 20.0;

// The article keeps the view direction constant; otherwise the direction points to the camera.
vec3 view_from(vec3 position) {
  return kAsCoded ? -normalize(frame.forward.xyz) : normalize(frame.camera.xyz - position);
}

vec3 direction_to(Light light, vec3 position) { return normalize(light.vector.xyz - position * light.vector.w); }

vec3 irradiance_of(Light light, vec3 position) {
  if (light.vector.w == 0.0) return light.irradiance.rgb;
  const vec3 to_light = light.vector.xyz - position;
  return light.irradiance.rgb / dot(to_light, to_light);
}

// Ambient and Lambert's cosine times the object's colour, plus a highlight of the light's colour.
vec3 lit(vec3 object_color, vec3 position, vec3 n, bool highlight) {
  const vec3 v = view_from(position);
  vec3 color = object_color * frame.ambient.rgb;
  for (int k = 0; k < frame.counts.x; ++k) {
    const Light light = frame.lights[k];
    const vec3 l = direction_to(light, position);
    const vec3 irradiance = irradiance_of(light, position);
    color += object_color * irradiance * max(dot(n, l), 0.0);
    // The half vector of the article adds a light vector that is not normalised.
    const vec3 h = normalize(v + (kAsCoded ? l * light.irradiance.w : l));
    if (highlight) color += irradiance * pow(max(dot(n, h), 0.0), kExponent);
  }
  return color;
}

// (n.h, n.l) of the first light: the lookup texture's coordinates.
vec2 lookup_coordinates(vec3 position, vec3 n) {
  const vec3 l = direction_to(frame.lights[0], position);
  return vec2(dot(n, normalize(l + view_from(position))), dot(n, l));
}
