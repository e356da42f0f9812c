// What every pass knows. The same structs in C++: gpu_layout.h.
struct Light {
  vec4 vector;      // point: position, w = 1; directional: unit vector to the light, w = 0
  vec4 irradiance;  // colour * intensity; w: length of the scene file's direction
};
layout(set = 0, binding = 0, std140) uniform Frame {
  mat4 view_projection;
  vec4 camera;
  vec4 right, up, forward;  // of the picture plane: the ray through ndc (x, y) is forward + x right + y up
  vec4 ambient, back_color, background, zenith;
  ivec4 counts;  // x: lights, y: there is a sky, zw: the picture's width and height
  Light lights[64];
} frame;

struct Item {
  mat4 model;          // column 3: the object's origin
  mat4 normals;
  vec4 weights[3];     // a: cosine and sine of tangent_phi, the object's extent
  vec4 shape;
  vec4 shape_low, shape_high;  // range of the 8-bit encoding
  ivec4 shape_roles;   // see texture_rule.h
  ivec4 weight_roles;  // w: which maps there are, bit per slot
  ivec4 form;          // x: index of the form, -1: none; y: shapes on a logarithmic scale, bit per slot
  vec4 weight_scale;   // x: of the 8-bit encoding
};
// A uniform buffer: the software driver loads from storage buffers lane by lane.
layout(set = 0, binding = 1, std140) uniform Items { Item items[224]; };

// From the camera through this place in the picture (gl_FragCoord.xy); not normalised.
vec3 ray_through(vec2 at) {
  const vec2 ndc = at / vec2(frame.counts.zw) * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
  return frame.forward.xyz + frame.right.xyz * ndc.x + frame.up.xyz * ndc.y;
}

// 16-bit targets hold the digits of the normal that rounding takes, times this, along tangent and bitangent.
const float kRemainderScale = 4096.0;
