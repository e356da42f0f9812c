// What every pass knows. The same structs in C++: gpu_layout.h.
#include "layout.glsl"
struct Light {
  vec4 vector;      // point: position, w = 1; directional: unit vector to the light, w = 0
  vec4 irradiance;  // colour * intensity; w: length of the scene file's direction
};
layout(set = 0, binding = 0, std140) uniform Frame {
  mat4 view_projection;
  vec4 camera;
  vec4 right, up, forward;  // of the picture plane: the ray through ndc (x, y) is forward + x right + y up
  vec4 ambient, back_color, background, zenith;
  vec4 environment;         // cosine and sine of its rotation, its intensity
  ivec4 counts;  // x: lights, y: there is a sky, or a backdrop (kBackdrop), zw: the picture's width and height
  mat4 shadow_projection;
  vec4 shadow;   // x: number of the light that casts one, -1: none; y: texels of the map across; z: number of objects
  Light lights[kMostLights];
} frame;

struct Item {
  mat4 model;          // column 3: the object's origin
  mat4 normals;
  vec4 weights[kMostWeights];  // a: cosine and sine of tangent_phi, the object's extent
  vec4 shape;
  vec4 shape_low, shape_high;  // range of the 8-bit encoding
  ivec4 shape_rules;   // see texture_rule.h
  ivec4 weight_rules;  // w: which maps there are, bit per slot
  // x: number of the reflectance, -1: none; y: shapes on a logarithmic scale, bit per slot, and kFourthShape; z, w: which of the weights
  // are the diffuse and the specular one, -1: none.
  ivec4 form;
  vec4 weight_scale;   // x: of the 8-bit encoding
};
// A uniform buffer: the software driver loads from storage buffers lane by lane.
layout(set = 0, binding = 1, std140) uniform Items { Item items[kMostItems]; };

// From the camera through this place in the picture (gl_FragCoord.xy); not normalised.
vec3 ray_through(vec2 at) {
  const vec2 ndc = at / vec2(frame.counts.zw) * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
  return frame.forward.xyz + frame.right.xyz * ndc.x + frame.up.xyz * ndc.y;
}

// The weight at a place of Item.form; nothing where there is none.
vec3 weight_at(vec3 weights[kMostWeights], int place) { return place < 0 ? vec3(0.0) : weights[place]; }
vec3 item_weight(Item item, int place) { return place < 0 ? vec3(0.0) : item.weights[place].rgb; }
