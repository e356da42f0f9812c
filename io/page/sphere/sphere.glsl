// One sphere under one directional light or in the studio, seen from far away. The page's fragment shader is
// brdf_material(), the functions of studio.h, and this.
uniform vec2 middle;         // centre of the sphere, pixels
uniform float radius;        // pixels
uniform mat3 camera;         // right, up, towards the viewer, in the frame of the sphere
uniform vec3 light;          // unit vector towards the light
uniform int shown;           // an index of `views` in sphere.js
uniform float gain;          // factor of the exposure
uniform highp sampler3D ratio;  // measured over fitted, see io/page/sphere/table.h
uniform vec4 counts;         // numbers of nodes of the ratio: theta_h, theta_d, phi_d, phi_h
uniform vec3 scale;          // the logarithms that bytes 0 and 255 represent, and the floor
uniform vec3 stations[5];    // colours of the difference
uniform float range;         // the relative difference at the ends of the colours
uniform vec4 hatching;       // period in pixels, dark, bright; the panel's side
uniform vec2 widths;         // of the lobes that the studio draws directions from
uniform vec2 room;           // cosine and sine of the studio's turn about the vertical axis
uniform ivec2 rounds;        // of the studio's directions: the first of this frame, and their number
uniform highp sampler2D sum; // of the rounds before this frame
out vec4 colour;
const float kPi = 3.14159265, kRim = 0.9999;  // at the rim itself, rounding could move the viewer below the horizon

// The light in the frame of the half vector (Rusinkiewicz 1998), as coordinates of the texture; phi_h in turns.
vec4 place_of(vec3 wi, vec3 wo) {
  vec3 h = normalize(wi + wo);
  float sine = length(h.xy);
  vec2 azimuth = sine > 1e-6 ? h.xy / sine : vec2(1.0, 0.0);
  vec2 across = vec2(-azimuth.y, azimuth.x);
  vec3 d = vec3(dot(wi, vec3(azimuth * h.z, -sine)), dot(wi.xy, across), dot(wi, h));
  float theta_h = atan(sine, h.z), theta_d = atan(length(d.xy), d.z);
  float phi_d = length(d.xy) > 1e-6 ? mod(atan(d.y, d.x), kPi) : 0.0;
  float phi_h = mod(atan(azimuth.y, azimuth.x), 2.0 * kPi);
  return vec4(sqrt(theta_h / (0.5 * kPi)), theta_d / (0.5 * kPi), phi_d / kPi, phi_h / (2.0 * kPi));
}

vec4 turned(vec4 place, float k) {
  float nodes = counts.z + 1.0;  // the last node repeats the first
  vec3 at = vec3(place.xy * (counts.xy - 1.0), mod(k, counts.w) * nodes + place.z * counts.z);
  return texture(ratio, (at + 0.5) / vec3(counts.xy, counts.w * nodes));
}

// Measured f_r; the fourth component is below 0.5 if there are no measurements nearby.
vec4 measured(vec3 wi, vec3 wo, vec3 fitted) {
  vec4 place = place_of(wi, wo);
  float turn = place.w * counts.w;
  vec4 found = mix(turned(place, floor(turn)), turned(place, floor(turn) + 1.0), fract(turn));
  vec3 logarithm = mix(scale.xxx, scale.yyy, found.rgb / max(found.a, 1e-3));
  return vec4((fitted + scale.z) * exp(logarithm), found.a);
}

// From directions of the sphere's frame to those of the studio, and back.
vec3 to_room(vec3 w) { return vec3(room.x * w.x - room.y * w.z, w.y, room.y * w.x + room.x * w.z); }
vec3 from_room(vec3 w) { return vec3(room.x * w.x + room.y * w.z, w.y, room.x * w.z - room.y * w.x); }

// The sum of these rounds; studio.cpp has the same.
vec3 in_studio(mat3 frame, vec3 wo) {
  vec3 total = vec3(0.0), place = to_room(frame[2]);
  for (int k = 0; k < rounds.y; ++k) {
    vec2 u = fract(0.5 + kStudioStep * float(rounds.x + k));
    mat3 boxes = studio_boxes(u);
    for (int j = 0; j < 6; ++j) {
      vec3 wi = j < 3 ? from_room(boxes[j]) * frame : j == 3 ? studio_cosine(u) : studio_lobe(widths[j - 4], u, wo);
      if (wi.z <= 0.0) continue;
      vec3 w = to_room(frame * wi);
      float density = studio_density(w) + wi.z / kPi + studio_lobe_density(widths.x, wi, wo) +
                      studio_lobe_density(widths.y, wi, wo);
      total += brdf_material(wi, wo) * studio_radiance(w) * (wi.z * studio_floor(place, w) / density);
    }
  }
  return total;
}

// Fitted over measured, minus 1, in colours.
vec3 difference(vec3 fitted, vec3 known) {
  float sum = max(dot(known, vec3(1.0)), 1e-30), relative = (dot(fitted, vec3(1.0)) - sum) / sum;
  float at = 4.0 * clamp(0.5 + 0.5 * relative / range, 0.0, 1.0);
  int k = min(int(at), 3);
  return mix(stations[k], stations[k + 1], at - float(k));
}

// The same as io/page/hatching.h, which counts rows from the top.
vec3 hatched() {
  vec2 corner = middle + hatching.w * vec2(-0.5, 0.5);  // the upper left corner
  float stripe = mod(floor(gl_FragCoord.x - corner.x) + floor(corner.y - gl_FragCoord.y), hatching.x);
  return vec3(stripe < hatching.x / 2.0 ? hatching.y : hatching.z);
}

void main() {
  vec2 p = (gl_FragCoord.xy - middle) / radius;
  float covered = clamp((1.0 - length(p)) * radius + 0.5, 0.0, 1.0);
  p *= min(1.0, kRim / max(length(p), kRim));
  vec3 n = camera * vec3(p, sqrt(max(0.0, 1.0 - dot(p, p))));
  vec3 t = cross(vec3(0.0, 1.0, 0.0), n);
  t = length(t) > 1e-6 ? normalize(t) : vec3(1.0, 0.0, 0.0);
  mat3 frame = mat3(t, cross(n, t), n), to_local = transpose(frame);
  if (shown == 7) {  // adds rounds
    colour = texelFetch(sum, ivec2(gl_FragCoord.xy), 0) + vec4(covered > 0.0 ? in_studio(frame, to_local * camera[2]) : vec3(0.0), 0.0);
    return;
  }
  if (shown == 8) {  // shows their mean
    colour = vec4(displayed(texelFetch(sum, ivec2(gl_FragCoord.xy), 0).rgb * (gain / float(rounds.x))) * covered, covered);
    return;
  }
  vec3 wi = to_local * light, wo = to_local * camera[2], fitted = brdf_material(wi, wo);
  vec4 known = counts.w > 0.0 ? measured(wi, wo, fitted) : vec4(0.0);
  if (shown >= 3) {  // values for readings
    colour = shown == 3 ? vec4(fitted, 1.0) : shown == 4 ? known : vec4(shown == 5 ? wi : wo, 1.0);
    return;
  }
  vec3 seen = displayed((shown == 0 ? fitted : known.rgb) * max(wi.z, 0.0) * gain);
  if (shown > 0 && wi.z > 0.0) seen = known.a < 0.5 ? hatched() : shown == 2 ? difference(fitted, known.rgb) : seen;
  if (shown == 2 && wi.z <= 0.0) seen = vec3(0.0);
  colour = vec4(seen * covered, covered);
}
