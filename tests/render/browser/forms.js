// Evaluates `data`, what forms_values prints, in WebGL 2; its results become the page's data-result.
"use strict";
const vertex = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;
const floats = text => new Float32Array(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);

function program(gl, fragment) {
  const made = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  return made;
}

function texture(gl, width, height, values) {
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, values);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return gl.getParameter(gl.TEXTURE_BINDING_2D);
}

// f and f cos_i of every configuration, six values each.
function evaluated(gl, form) {
  const side = data.side, out = [0, 1].map(() => texture(gl, side, side, null));
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  out.forEach((target, k) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + k, gl.TEXTURE_2D, target, 0));
  gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  gl.viewport(0, 0, side, side);
  gl.useProgram(program(gl, form.shader));
  texture(gl, 6 * side, side, floats(form.rows));
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const values = new Float32Array(6 * side * side), pixels = new Float32Array(4 * side * side);
  for (const k of [0, 1]) {
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + k);
    gl.readPixels(0, 0, side, side, gl.RGBA, gl.FLOAT, pixels);
    for (let i = 0; i < side * side; ++i) values.set(pixels.subarray(4 * i, 4 * i + 3), 6 * i + 3 * k);
  }
  return values;
}

// The difference over the largest value of the same parameters, channel and quantity.
function compared(form, device) {
  const library = floats(form.values), bits = [new Uint32Array(device.buffer), new Uint32Array(library.buffer)];
  const block = 6 * data.one_set, row = {form: form.name, values: library.length, differing: 0, worst: 0, peak: 0};
  for (let start = 0; start < library.length; start += block) {
    const peaks = [0, 0, 0, 0, 0, 0];
    for (let i = start; i < start + block; ++i) peaks[i % 6] = Math.max(peaks[i % 6], Math.abs(library[i]));
    row.peak = Math.max(row.peak, ...peaks);
    for (let i = start; i < start + block; ++i) {
      if (bits[0][i] === bits[1][i]) continue;
      ++row.differing;
      const difference = Math.abs(device[i] - library[i]);
      row.worst = Math.max(row.worst, Number.isFinite(difference) ? difference / peaks[i % 6] : 1e300);
    }
  }
  return row;
}

const gl = document.createElement("canvas").getContext("webgl2");
if (!gl || !gl.getExtension("EXT_color_buffer_float")) throw new Error("no WebGL 2 with float targets");
const named = gl.getExtension("WEBGL_debug_renderer_info");
document.documentElement.dataset.result = JSON.stringify({
  renderer: gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
  rows: data.forms.map(form => compared(form, evaluated(gl, form))),
});
