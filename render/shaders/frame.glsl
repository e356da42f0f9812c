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
  ivec4 counts;  // x: lights, y: there is a sky
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
