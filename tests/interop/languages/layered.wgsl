// The functions of layered.glsl.
const PI: f32 = 3.14159265;

fn brdf(L: vec3<f32>, V: vec3<f32>, base: f32, coat: f32, shininess: f32) -> f32 {
  if (L.z <= 0.0 || V.z <= 0.0) {
    return 0.0;
  }
  let H = normalize(L + V);
  return base / PI + coat * (shininess + 2.0) / (8.0 * PI) * pow(H.z, shininess);
}

fn brdfPdf(L: vec3<f32>, V: vec3<f32>, shininess: f32) -> f32 {
  if (L.z <= 0.0 || V.z <= 0.0) {
    return 0.0;
  }
  let H = normalize(L + V);
  var gloss = (shininess + 1.0) / (2.0 * PI) * pow(H.z, shininess);
  gloss /= 4.0 * dot(V, H);
  return 0.5 * L.z / PI + 0.5 * gloss;
}

fn brdfSample(u: vec3<f32>, V: vec3<f32>, shininess: f32) -> vec3<f32> {
  let phi = 2.0 * PI * u.y;
  if (u.z < 0.5) {
    let c = pow(1.0 - u.x, 1.0 / (shininess + 1.0));
    let s = sqrt(1.0 - c * c);
    return reflect(-V, vec3<f32>(s * cos(phi), s * sin(phi), c));
  }
  return vec3<f32>(sqrt(u.x) * cos(phi), sqrt(u.x) * sin(phi), sqrt(1.0 - u.x));
}

@fragment
fn main(@location(0) L: vec3<f32>, @location(1) V: vec3<f32>, @location(2) u: vec3<f32>, @location(3) p: vec3<f32>)
    -> @location(0) vec4<f32> {
  return vec4<f32>(brdfSample(u, V, p.z), brdf(L, V, p.x, p.y, p.z) + brdfPdf(L, V, p.z));
}
