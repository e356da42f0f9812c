// Bodies over directions that readers turn (io/page/body.h): every figure.body gets a canvas in place of its picture. The
// faces are painted from back to front. Without scripts the picture remains.
(() => {
  "use strict";
  const radians = degrees => degrees * Math.PI / 180;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const minus = (a, b) => a.map((v, k) => v - b[k]), times = (s, a) => a.map(v => s * v);
  const css = rgb => `rgb(${ rgb.map(Math.round).join() })`;
  const towards = (theta, phi) => [Math.sin(radians(theta)) * Math.cos(radians(phi)),
    Math.sin(radians(theta)) * Math.sin(radians(phi)), Math.cos(radians(theta))];
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

  function decoded(data) {
    const packed = bytes(data.points), shares = bytes(data.dots), points = [], colours = [], dots = [];
    for (let ring = 0; ring < data.rings; ++ring)
      for (let sector = 0; sector < data.sectors; ++sector) {
        const [radius, ...colour] = packed.slice(4 * points.length, 4 * points.length + 4);
        points.push(times(radius / 255, towards(ring * data.reach / (data.rings - 1), 360 * sector / data.sectors)));
        colours.push(colour);
      }
    const share = k => (shares[2 * k] + 256 * shares[2 * k + 1]) / 65535;
    for (let k = 0; 2 * k < shares.length; k += 3)
      dots.push(times(share(k + 2), towards(90 * share(k), 360 * share(k + 1))));
    return { points, colours, dots };
  }

  class Body {
    constructor(figure) {
      this.data = JSON.parse(figure.querySelector("script").textContent);
      Object.assign(this, decoded(this.data));
      this.canvas = figure.querySelector("canvas");
      figure.classList.add("turns");
      const keys = { ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] };
      this.canvas.addEventListener("keydown", event => {
        if (event.key in keys) this.move(...keys[event.key]);
        else if (event.key === "Home") this.reset();
        else return;
        event.preventDefault();
      });
      this.canvas.addEventListener("pointerdown", event => this.canvas.setPointerCapture(event.pointerId));
      this.canvas.addEventListener("pointermove", event => {
        if (event.buttons) this.move(-event.movementX / 2, event.movementY / 2);
      });
      this.reset();
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    reset() {
      [this.turn, this.above] = this.data.view;
      this.draw();
    }

    move(turn, above) {
      this.turn = (this.turn + turn) % 360;
      this.above = Math.min(90, Math.max(0, this.above + above));
      this.draw();
    }

    draw() {
      this.waiting ??= requestAnimationFrame(() => {
        this.waiting = undefined;
        this.paint();
      });
    }

    // The view has no perspective; x of the body points to the mirror direction.
    frame() {
      const [ct, st] = [Math.cos(radians(this.turn)), Math.sin(radians(this.turn))];
      const [ca, sa] = [Math.cos(radians(this.above)), Math.sin(radians(this.above))];
      const right = [ct, st, 0], back = [st * ca, -ct * ca, sa];
      return { right, back, up: cross(back, right) };
    }

    faces({ right, up, back }) {
      const { rings, sectors } = this.data;
      const light = minus(minus(times(0.5, up), times(-0.8, back)), times(0.4, right));
      const strength = 1 / Math.hypot(...light), faces = [];
      for (let ring = 0; ring + 1 < rings; ++ring)
        for (let sector = 0; sector < sectors; ++sector) {
          const at = (r, s) => r * sectors + s % sectors, first = at(ring, sector);
          const corners = [first, at(ring, sector + 1), at(ring + 1, sector + 1), at(ring + 1, sector)].map(k => this.points[k]);
          let normal = cross(minus(corners[2], corners[0]), minus(corners[1], corners[3]));
          const length = Math.hypot(...normal), middle = times(0.5, corners[0].map((v, k) => v + corners[2][k]));
          if (!(length > 0)) continue;
          if (dot(normal, middle) < 0) normal = times(-1, normal);
          const shade = 0.3 + 0.7 * Math.max(0, strength * dot(normal, light) / length);
          faces.push({ depth: dot(middle, back), corners, colour: css(times(shade, this.colours[first])) });
        }
      return faces;
    }

    paint() {
      const width = this.canvas.clientWidth * Math.min(devicePixelRatio, 2), height = 0.72 * width;
      if (width < 1) return;
      Object.assign(this.canvas, { width, height });
      const pen = this.canvas.getContext("2d"), frame = this.frame(), { colours } = this.data;
      const place = p => [width / 2 + 0.45 * width * dot(p, frame.right), 0.5 * width - 0.45 * width * dot(p, frame.up)];
      const path = (points, close) => {
        pen.beginPath();
        for (const p of points) pen.lineTo(...place(p));
        if (close) pen.closePath();
      };
      const line = (points, colour, thick) => {
        path(points);
        Object.assign(pen, { strokeStyle: css(colour), lineWidth: thick * width / 480 });
        pen.stroke();
      };
      const spot = p => {
        pen.beginPath();
        pen.arc(...place(p), 3 * width / 480, 0, 7);
        pen.fillStyle = css(colours.dots);
        pen.fill();
      };
      pen.fillStyle = css(colours.background);
      pen.fillRect(0, 0, width, height);
      for (const radius of [0.5, 1])
        line([...Array(91).keys()].map(k => times(radius, towards(90, 4 * k))), colours.ground, 1);
      for (let phi = 0; phi < 360; phi += 45) line([[0, 0, 0], towards(90, phi)], colours.ground, 1);
      line([[0, 0, 0], [0, 0, 1]], colours.ground, 1);
      line([[0, 0, 0], towards(this.data.light, 180)], colours.light, 2);
      line([[0, 0, 0], towards(this.data.light, 0)], colours.mirror, 1);
      // A dot that agrees with the surface lies on it, so that it is counted as in front.
      const dots = this.dots.map(p => ({ depth: dot(p, frame.back) + 0.01 + 1 / this.data.rings, p }));
      const things = this.faces(frame).concat(dots).sort((a, b) => a.depth - b.depth);
      for (const { p, corners, colour } of things) {
        if (p) {
          spot(p);
          continue;
        }
        path(corners, true);
        Object.assign(pen, { fillStyle: colour, strokeStyle: colour, lineWidth: 1 });
        pen.fill();
        pen.stroke();  // hides the seam to the next face
      }
      pen.globalAlpha = 0.25;  // dots behind the body
      for (const p of this.dots) spot(p);
      pen.globalAlpha = 1;
    }
  }

  for (const figure of document.querySelectorAll("figure.body")) figure.shown = new Body(figure);
})();
