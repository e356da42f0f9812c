#version 460
#extension GL_GOOGLE_include_directive : require
layout(constant_id = 0) const int kForm = 0;  // one pipeline per form: a uniform branch would evaluate all of them
layout(constant_id = 1) const int kBits = 16;
layout(constant_id = 2) const bool kSingle = false;  // only one item has this form: its data are the same for all pixels
layout(push_constant) uniform Push { int item; } push;
#include "frame.glsl"
#include "brdf.glsl"
#include "shade.glsl"
layout(set = 1, binding = 0) uniform sampler2D targets[kTargetCount];  // in the order of gbuffer.frag
layout(location = 0) out vec4 color;

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  const vec4 place = texelFetch(targets[target_position], pixel, 0);
  const int stored = int((kBits == 8 ? place.a * 255.0 : place.a) + 0.5) - 1;
  if (stored < 0 || (kSingle ? stored != push.item : items[stored].form.x != kForm)) discard;
  const int id = kSingle ? push.item : stored;
  const vec4 albedo = texelFetch(targets[target_albedo], pixel, 0);
  if (albedo.a < 0.5) {
    color = vec4(frame.back_color.rgb, 1.0);
    return;
  }
  vec4 normal = texelFetch(targets[target_normal], pixel, 0);
  vec4 tangent = texelFetch(targets[target_tangent], pixel, 0);
  vec4 bitangent = texelFetch(targets[target_bitangent], pixel, 0);
  vec4 shape = texelFetch(targets[target_roughness], pixel, 0);
  const vec4 specular = texelFetch(targets[target_specular], pixel, 0);
  vec3 w[kMostWeights] = vec3[](albedo.rgb, specular.rgb, vec3(normal.a, tangent.a, bitangent.a));
  vec3 relative = place.xyz;
  if (kBits == 8) {
    normal.xyz = normal.xyz * 2.0 - 1.0;
    tangent.xyz = tangent.xyz * 2.0 - 1.0;
    bitangent.xyz = bitangent.xyz * 2.0 - 1.0;
    relative = (relative * 2.0 - 1.0) * items[id].weights[2].a;
    w[0] *= items[id].weight_scale.x;
    w[1] *= items[id].weight_scale.x;
    shape = mix(items[id].shape_low, items[id].shape_high, shape);
    for (int k = 0; k < 4; ++k) {
      if ((items[id].form.y >> k & 1) != 0) shape[k] = exp2(shape[k]);
    }
  }
  if (kBits == 16) {
    normal.xyz += (specular.a * tangent.xyz + shape.a * bitangent.xyz) * (1.0 / kRemainderScale);
  }
  // Repair the frame: rounding took its unit lengths and right angles; the bitangent still says which hand it is.
  const vec3 n = normalize(normal.xyz);
  const vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
  vec3 b = cross(n, t);
  if (dot(b, bitangent.xyz) < 0.0) b = -b;
  // The pixel says where its surface point lies but for the depth: rounding of the position takes digits of that alone.
  const vec3 ray = ray_through(gl_FragCoord.xy);
  vec3 position = items[id].model[3].xyz + relative;
  if (kBits != 32) position = frame.camera.xyz + ray * (dot(position - frame.camera.xyz, ray) / dot(ray, ray));
  shadow_receiver = id;
  color = vec4(shade(kForm, position, normalize(ray), n, t, b, w, items[id].form.z, shape), 1.0);
}
