// The surface that the targets store under a fragment. The shader defines kForm, kBits, kSingle and push.item; fragments
// covered by another form are discarded.
layout(set = 1, binding = 0) uniform sampler2D targets[kTargetCount];  // in the order of gbuffer.frag

struct StoredSurface {
  int item;
  bool front;
  vec3 weights[kMostWeights];
  vec4 shape;
  vec3 position, ray;  // ray: from the camera, not normalised
  vec3 normal, tangent, bitangent;
};

StoredSurface stored_surface() {
  StoredSurface s;
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  const vec4 place = texelFetch(targets[target_position], pixel, 0);
  const int stored = int((kBits == 8 ? place.a * 255.0 : place.a) + 0.5) - 1;
  if (stored < 0 || (kSingle ? stored != push.item : items[stored].form.x != kForm)) discard;
  const int id = kSingle ? push.item : stored;
  const vec4 albedo = texelFetch(targets[target_albedo], pixel, 0);
  s.item = id;
  s.front = albedo.a >= 0.5;
  if (!s.front) return s;
  vec4 normal = texelFetch(targets[target_normal], pixel, 0);
  vec4 tangent = texelFetch(targets[target_tangent], pixel, 0);
  vec4 bitangent = texelFetch(targets[target_bitangent], pixel, 0);
  s.shape = texelFetch(targets[target_roughness], pixel, 0);
  const vec4 specular = texelFetch(targets[target_specular], pixel, 0);
  s.weights = vec3[](albedo.rgb, specular.rgb, vec3(normal.a, tangent.a, bitangent.a));
  vec3 relative = place.xyz;
  if (kBits == 8) {
    normal.xyz = normal.xyz * 2.0 - 1.0;
    tangent.xyz = tangent.xyz * 2.0 - 1.0;
    bitangent.xyz = bitangent.xyz * 2.0 - 1.0;
    relative = (relative * 2.0 - 1.0) * items[id].weights[2].a;
    s.weights[0] *= items[id].weight_scale.x;
    s.weights[1] *= items[id].weight_scale.x;
    s.shape = mix(items[id].shape_low, items[id].shape_high, s.shape);
    for (int k = 0; k < 4; ++k) {
      if ((items[id].form.y >> k & 1) != 0) s.shape[k] = exp2(s.shape[k]);
    }
  }
  if (kBits == 16) {
    normal.xyz += (specular.a * tangent.xyz + s.shape.a * bitangent.xyz) * (1.0 / kRemainderScale);
  }
  if (kBits != 8 && (items[id].form.y & kFourthShape) != 0) s.shape.a = normal.a;
  // Repairs the frame: rounding changed lengths and right angles; the bitangent gives the handedness.
  s.normal = normalize(normal.xyz);
  s.tangent = normalize(tangent.xyz - s.normal * dot(s.normal, tangent.xyz));
  s.bitangent = cross(s.normal, s.tangent);
  if (dot(s.bitangent, bitangent.xyz) < 0.0) s.bitangent = -s.bitangent;
  // The pixel determines the surface point except for the depth, so rounding of the position affects the depth only.
  s.ray = ray_through(gl_FragCoord.xy);
  s.position = items[id].model[3].xyz + relative;
  if (kBits != 32)
    s.position = frame.camera.xyz + s.ray * (dot(s.position - frame.camera.xyz, s.ray) / dot(s.ray, s.ray));
  return s;
}
