// Data of every pass. The same structs in C++: gpu_layout.h.
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
  vec4 environment;         // cosine and sine of the rotation, intensity, height of the floor or kNoFloor
  ivec4 counts;  // x: lights, y: 1 for a sky, kBackdrop for a backdrop, zw: width and height of the picture
  mat4 shadow_projection;
  vec4 shadow;   // x: number of the light with a shadow, or -1; y: width of the map in texels; z: number of objects
  Light lights[kMostLights];
} frame;

struct Item {
  mat4 model;          // column 3: origin of the object
  mat4 normals;
  vec4 weights[kMostWeights];  // a: cosine and sine of tangent_phi, the object's extent
  vec4 shape;
  vec4 shape_low, shape_high;  // range of the 8-bit encoding
  ivec4 shape_rules;   // see texture_rule.h
  ivec4 weight_rules;  // w: maps that exist, one bit per slot
  // x: number of the reflectance, or -1; y: shapes on a logarithmic scale, one bit per slot, and kFourthShape; z, w: indices
  // of the diffuse and of the specular
  // weight, or -1.
  ivec4 form;
  vec4 weight_scale;   // x: of the 8-bit encoding
};
// A uniform buffer: the software driver loads from storage buffers lane by lane.
layout(set = 0, binding = 1, std140) uniform Items { Item items[kMostItems]; };

// The direction from the camera through this place of the picture (gl_FragCoord.xy); not normalised.
vec3 ray_through(vec2 at) {
  const vec2 ndc = at / vec2(frame.counts.zw) * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
  return frame.forward.xyz + frame.right.xyz * ndc.x + frame.up.xyz * ndc.y;
}

// The weight at a place of Item.form; 0 if the place is -1.
vec3 weight_at(vec3 weights[kMostWeights], int place) { return place < 0 ? vec3(0.0) : weights[place]; }
vec3 item_weight(Item item, int place) { return place < 0 ? vec3(0.0) : item.weights[place].rgb; }
