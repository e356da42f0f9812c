// Interactive spheres: every figure.sphere of the page gets a canvas instead of its still picture. One WebGL
// context draws all of them (browsers allow few), so the canvases of the figures are plain and print. Without WebGL 2,
// or until a sphere becomes visible, the still picture remains.
(() => {
  "use strict";
  const views = ["fitted", "measured", "difference"], values = { fitted: 3, measured: 4, wi: 5, wo: 6 };
  const mostRounds = 256;  // of directions of the studio's light
  const start = { turn: 0, tilt: 0, lightTurn: -35, lightTilt: 30 };
  const radians = degrees => degrees * Math.PI / 180;
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const direction = (turn, tilt) => [Math.sin(radians(turn)) * Math.cos(radians(tilt)), Math.sin(radians(tilt)),
    Math.cos(radians(turn)) * Math.cos(radians(tilt))];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const clamp = (x, low, high) => Math.min(high, Math.max(low, x));
  const degreesOf = cosine => (Math.acos(clamp(cosine, -1, 1)) * 180 / Math.PI).toFixed(1) + "\u00b0";

  const gl = document.createElement("canvas").getContext("webgl2", { antialias: false });
  if (!gl) return;
  const reads = gl.getExtension("EXT_color_buffer_float") !== null;
  const corners = `#version 300 es
    void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;

  function programOf(fragment) {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, corners], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (gl.getProgramParameter(program, gl.LINK_STATUS)) return program;
    throw new Error(gl.getAttachedShaders(program).map(s => gl.getShaderInfoLog(s)).join("") || "no program");
  }

  function textureOf(table) {
    const texture = gl.createTexture(), [a, b, c, d] = table.counts;
    gl.bindTexture(gl.TEXTURE_3D, texture);
    gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGBA8, a, b, (c + 1) * d, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes(table.bytes));
    for (const [name, value] of [["MIN_FILTER", "LINEAR"], ["MAG_FILTER", "LINEAR"], ["WRAP_S", "CLAMP_TO_EDGE"],
      ["WRAP_T", "CLAMP_TO_EDGE"], ["WRAP_R", "CLAMP_TO_EDGE"]])
      gl.texParameteri(gl.TEXTURE_3D, gl["TEXTURE_" + name], gl[value]);
    return texture;
  }

  // A square of floats to draw into.
  function floatTarget(side) {
    const target = gl.createFramebuffer(), texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, side, side);
    for (const filter of ["MIN_FILTER", "MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl["TEXTURE_" + filter], gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.bindTexture(gl.TEXTURE_2D, null);  // a texture that is drawn into must not be readable
    return { target, texture };
  }

  // A measured sphere has the shader of the sphere in the studio before it.
  function shaderOf(figure) {
    const all = [...document.querySelectorAll("figure.sphere")], at = all.indexOf(figure);
    const shaders = all.slice(0, at + 1).map(f => JSON.parse(f.querySelector("script").textContent).shader);
    return shaders.filter(shader => shader).pop();
  }

  class Sphere {
    constructor(figure) {
      this.figure = figure;
      this.data = JSON.parse(figure.querySelector("script").textContent);
      this.studio = this.data.studio;
      this.program = programOf(shaderOf(figure));
      this.table = this.data.table && textureOf(this.data.table);
      this.canvas = figure.querySelector("canvas");
      this.show = figure.querySelector(".show");
      this.moves = figure.querySelector(".moves");
      this.exposure = figure.querySelector(".exposure");
      this.reading = figure.querySelector(".reading");
      figure.classList.add("turns");
      this.listen();
      this.reset();
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    panels() {
      if (!this.table) return [0];
      return this.show.value === "all" ? [0, 1, 2] : [views.indexOf(this.show.value)];
    }

    reset() {
      Object.assign(this, start);
      this.from = undefined;
      this.exposure.value = this.data.exposure;
      this.draw();
    }

    move(light, x, y) {  // degrees
      const [turn, tilt] = light ? ["lightTurn", "lightTilt"] : ["turn", "tilt"], way = light ? 1 : -1;
      this[turn] = (this[turn] + way * x) % 360;
      this[tilt] = clamp(this[tilt] + way * y, -89, 89);
      this.draw();
    }

    listen() {
      const light = event => event.shiftKey || event.ctrlKey || this.moves.value === "light";
      const keys = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
      this.canvas.addEventListener("keydown", event => {
        if (event.key in keys) this.move(light(event), ...keys[event.key]);
        else if (event.key === "Home") this.reset();
        else return;
        event.preventDefault();
      });
      this.canvas.addEventListener("pointerdown", event => this.canvas.setPointerCapture(event.pointerId));
      this.canvas.addEventListener("pointermove", event => {
        if (event.buttons) this.move(light(event), event.movementX / 2, -event.movementY / 2);
        else this.tell(event.offsetX, event.offsetY);
      });
      this.figure.querySelector(".reset").addEventListener("click", () => this.reset());
      for (const control of [this.show, this.exposure]) control.addEventListener("input", () => this.draw());
    }

    draw() {
      this.waiting ??= requestAnimationFrame(() => {
        this.waiting = undefined;
        this.paint();
        if (this.studio && this.done < mostRounds) this.draw();
      });
    }

    // Returns the panel under a point and the point in the panel: CSS pixels from its lower left corner.
    panelAt(x, y) {
      const panels = this.panels(), side = this.canvas.clientWidth / panels.length;
      const k = clamp(Math.floor(x / side), 0, panels.length - 1);
      return { side, x: x - k * side, y: side - y };
    }

    uniforms(side) {
      const at = name => gl.getUniformLocation(this.program, name);
      const towards = direction(this.turn, this.tilt), right = direction(this.turn + 90, 0);
      const light = direction(this.lightTurn, this.lightTilt);
      gl.useProgram(this.program);
      gl.uniform1f(at("radius"), 0.47 * side);
      gl.uniformMatrix3fv(at("camera"), false, [...right, ...cross(towards, right), ...towards]);
      gl.uniform3fv(at("light"), light);
      gl.uniform1f(at("gain"), (this.studio ? 1 : Math.PI) * 2 ** this.exposure.value);
      if (this.studio) {
        const turned = radians(this.lightTurn - start.lightTurn);
        gl.uniform2f(at("room"), Math.cos(turned), Math.sin(turned));
        gl.uniform2fv(at("widths"), this.studio);
      }
      gl.uniform1i(at("ratio"), 0);
      gl.uniform1i(at("sum"), 1);
      gl.activeTexture(gl.TEXTURE0);
      gl.uniform3fv(at("stations"), this.data.stations.flat());
      gl.uniform1f(at("range"), this.data.range ?? 1);
      gl.uniform4fv(at("hatching"), [...this.data.hatching, side]);
      gl.uniform4fv(at("counts"), this.table ? this.data.table.counts : [0, 0, 0, 0]);
      gl.uniform3fv(at("scale"), this.table ? this.data.table.scale : [0, 0, 0]);
      gl.bindTexture(gl.TEXTURE_3D, this.table || null);
      return { shown: at("shown"), middle: at("middle"), rounds: at("rounds"), angle: degreesOf(dot(light, towards)) };
    }

    paint() {
      const panels = this.panels(), dense = Math.min(devicePixelRatio, 2);
      const side = Math.min(1024, Math.round(this.canvas.clientWidth / panels.length * dense));
      if (side < 1) return;
      this.figure.classList.toggle("single", panels.length === 1);
      Object.assign(this.canvas, { width: side * panels.length, height: side });
      gl.canvas.width = Math.max(gl.canvas.width, this.canvas.width);
      gl.canvas.height = Math.max(gl.canvas.height, side);
      const uniforms = this.uniforms(side);
      if (this.studio) this.addRounds(uniforms, side);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      panels.forEach((shown, k) => {
        gl.viewport(k * side, 0, side, side);
        gl.uniform1i(uniforms.shown, this.studio ? 8 : shown);
        gl.uniform2f(uniforms.middle, (k + 0.5) * side, 0.5 * side);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(k * side, 0, side, side);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      });
      this.canvas.getContext("2d").drawImage(gl.canvas, 0, gl.canvas.height - side, this.canvas.width, side, 0, 0,
        this.canvas.width, side);
      this.figure.dataset.shown = this.studio ? "studio" : panels.map(k => views[k]).join(" ");
      this.reading.textContent = this.studio ? "" : `light ${uniforms.angle} from the viewer`;
    }

    // Adds rounds of directions to the sum, which starts anew if the view has changed. The number of rounds follows the
    // time of the last frame; the textures of the sum take turns.
    addRounds(uniforms, side) {
      const view = JSON.stringify([this.turn, this.tilt, this.lightTurn, side]), now = performance.now();
      if (this.from !== view) {
        if (this.side !== side) {
          for (const { target, texture } of this.sums || []) gl.deleteFramebuffer(target), gl.deleteTexture(texture);
          this.sums = [0, 1].map(() => floatTarget(side));
        }
        this.done = 0;
      } else if (this.done < mostRounds) {
        const frame = now - this.last;
        this.step = clamp(Math.round(this.step * (frame < 25 ? 2 : frame > 60 ? 0.5 : 1)), 1, 16);
      }
      Object.assign(this, { from: view, side, last: now });
      this.step = Math.max(this.step || 0, 2);
      gl.activeTexture(gl.TEXTURE1);
      if (this.done < mostRounds) {
        const [before, after] = this.sums, count = Math.min(this.step, mostRounds - this.done);
        if (this.done === 0) {
          gl.bindFramebuffer(gl.FRAMEBUFFER, before.target);
          gl.disable(gl.SCISSOR_TEST);
          gl.clearColor(0, 0, 0, 0);
          gl.clear(gl.COLOR_BUFFER_BIT);
        }
        gl.bindTexture(gl.TEXTURE_2D, before.texture);
        gl.bindFramebuffer(gl.FRAMEBUFFER, after.target);
        gl.disable(gl.SCISSOR_TEST);
        gl.viewport(0, 0, side, side);
        gl.uniform1i(uniforms.shown, 7);
        gl.uniform2f(uniforms.middle, 0.5 * side, 0.5 * side);
        gl.uniform2i(uniforms.rounds, this.done, count);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        this.sums.reverse();
        this.done += count;
      }
      gl.bindTexture(gl.TEXTURE_2D, this.sums[0].texture);
      gl.uniform2i(uniforms.rounds, this.done, 0);
    }

    // Returns directions and f_r at a point of the canvas, in the floats of the shader; null outside the sphere.
    read(x, y) {
      const place = this.panelAt(x, y), { side } = place, far = Math.hypot(place.x - side / 2, place.y - side / 2);
      if (!reads || far > 0.47 * side) return null;
      this.target ??= floatTarget(1);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.target);
      gl.disable(gl.SCISSOR_TEST);
      gl.viewport(0, 0, 1, 1);
      const uniforms = this.uniforms(side), pixel = new Float32Array(4), found = {};
      gl.uniform2f(uniforms.middle, 0.5 + side / 2 - place.x, 0.5 + side / 2 - place.y);
      for (const [name, shown] of Object.entries(values)) {
        gl.uniform1i(uniforms.shown, shown);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixel);
        found[name] = [...pixel];
      }
      return found;
    }

    tell(x, y) {
      if (this.studio) return;
      const found = this.read(x, y);
      if (!found) return;
      const three = f => f.slice(0, 3).map(v => v.toPrecision(3)).join(", ");
      const measured = !this.table ? "" : found.measured[3] < 0.5 ? "; not measured" : `; measured ${three(found.measured)}`;
      this.reading.textContent = found.wi[2] <= 0 ? "in the dark" :
        `\u03b8i ${degreesOf(found.wi[2])}, \u03b8o ${degreesOf(found.wo[2])}: fitted ${three(found.fitted)}${measured} /sr`;
    }
  }

  const seen = new IntersectionObserver(entries => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      // The studio's sum needs floats; without them the still picture remains.
      if (reads || target.classList.contains("measured")) target.sphere = new Sphere(target);
    }
  }, { rootMargin: "300px" });
  for (const figure of document.querySelectorAll("figure.sphere")) seen.observe(figure);
})();
