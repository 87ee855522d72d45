// SPDX-License-Identifier: MIT
// Draws one moment of a life on a canvas: the world, the body, its way, and a scale bar.
//
//   planula.drawScene(pen, size, state, world, camera, look)
//     size      {width, height} in CSS pixels
//     state     what planula.motion().at() gave
//     world     what planula.motion().world() gave; null while it grows
//     camera    {x, y, scale}: what is in the middle, and pixels per cell
//     look      {theme, colours, radius, links, outline, way, chosen}
//       colours a colour per cell, or null; way: {path, from, to}, frames of the way, or null
'use strict';
(function () {
  const turn = 2 * Math.PI;

  /** The largest of 1, 2, 5, 10, 20, … that is at most `value`. */
  function round(value) {
    const power = 10 ** Math.floor(Math.log10(value)), lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
  }

  function heightOf(line, x) {
    if (!line.length) return 0;
    if (x <= line[0][0]) return line[0][1];
    for (let i = 1; i < line.length; ++i)
      if (x <= line[i][0]) {
        const [ax, ay] = line[i - 1], [bx, by] = line[i];
        return ay + ((x - ax) / (bx - ax)) * (by - ay);
      }
    return line.at(-1)[1];
  }

  class Scene {
    constructor(pen, size, camera, look) {
      Object.assign(this, { pen, size, camera, look, theme: look.theme });
      this.left = camera.x - size.width / 2 / camera.scale;
      this.right = camera.x + size.width / 2 / camera.scale;
      this.bottom = camera.y - size.height / 2 / camera.scale;
      this.top = camera.y + size.height / 2 / camera.scale;
    }

    x(x) { return this.size.width / 2 + (x - this.camera.x) * this.camera.scale; }
    y(y) { return this.size.height / 2 - (y - this.camera.y) * this.camera.scale; }

    polygon(points) {
      this.pen.beginPath();
      points.forEach(([x, y], i) => (i ? this.pen.lineTo(this.x(x), this.y(y)) : this.pen.moveTo(this.x(x), this.y(y))));
    }

    text(words, x, y, align) {
      this.pen.font = '12px system-ui, sans-serif';
      this.pen.textAlign = align || 'left';
      this.pen.fillStyle = this.theme.muted;
      this.pen.fillText(words, x, y);
    }

    // ---- The world -------------------------------------------------------------------------------------------------

    backdrop(world) {
      const { pen, size, theme } = this, wet = world && (world.drag[0] > 0 || world.drag[1] > 0);
      const shade = pen.createLinearGradient(0, 0, 0, size.height);
      shade.addColorStop(0, wet ? theme.waterTop : theme.air);
      shade.addColorStop(1, wet ? theme.waterBottom : theme.air);
      pen.fillStyle = shade;
      pen.fillRect(0, 0, size.width, size.height);
    }

    /** Dots that are fixed in the world, so that movement shows. */
    grid() {
      const { pen } = this, step = 2 * round(36 / this.camera.scale);
      pen.fillStyle = this.theme.grid;
      for (let x = Math.ceil(this.left / step) * step; x <= this.right; x += step)
        for (let y = Math.ceil(this.bottom / step) * step; y <= this.top; y += step)
          pen.fillRect(this.x(x) - 1, this.y(y) - 1, 2, 2);
    }

    /** The regions of the world, or what is written on them. */
    regions(world, isText) {
      for (const region of world.regions) {
        const left = Math.max(region.left ?? this.left, this.left), right = Math.min(region.right ?? this.right, this.right);
        const low = Math.max(region.bottom ?? this.bottom, this.bottom), high = Math.min(region.top ?? this.top, this.top);
        if (left >= right || low >= high) continue;
        const wet = region.drag[0] > 0 || region.drag[1] > 0;
        if (isText) {
          this.regionText(region, wet, this.x(right), this.y(high));
          continue;
        }
        const box = [this.x(left), this.y(high), (right - left) * this.camera.scale, (high - low) * this.camera.scale];
        this.pen.fillStyle = wet ? this.theme.region : this.theme.air;
        this.pen.fillRect(...box);
        this.pen.strokeStyle = this.theme.regionEdge;
        this.pen.lineWidth = 1;
        this.pen.setLineDash([5, 4]);
        this.pen.strokeRect(...box);
        this.pen.setLineDash([]);
      }
    }

    regionText(region, wet, right, top) {
      const words = [wet ? 'drag ' + region.drag.join(', ') : 'no fluid'];
      if (region.flow) words.push('flow ' + region.flow.join(', '));
      if (region.buoyancy !== null) words.push('buoyancy ' + region.buoyancy);
      this.text(words.join(' · '), right - 8, top + 18, 'right');
    }

    /** A line of ground or ceiling from left of the picture to right of it, closed at a height. */
    lineInView(line, height) {
      const left = this.left - 1, right = this.right + 1, inner = line.filter(([x]) => x > left && x < right);
      return [[left, height], [left, heightOf(line, left)], ...inner, [right, heightOf(line, right)], [right, height]];
    }

    solid(points) {
      const { pen, theme } = this;
      this.polygon(points);
      pen.fillStyle = theme.solid;
      pen.fill();
      pen.strokeStyle = theme.solidEdge;
      pen.lineWidth = 1.5;
      pen.stroke();
    }

    ground(world) {
      for (const obstacle of world.obstacles) this.solid([...obstacle.points, obstacle.points[0]]);
      if (world.ground) this.solid(this.lineInView(world.ground, this.bottom - 1));
      if (world.ceiling) this.solid(this.lineInView(world.ceiling, this.top + 1));
      for (const patch of world.patches) if (world.ground) this.patch(patch, world);
    }

    /** A part of the ground with another friction. */
    patch([from, to, friction], world) {
      const inner = world.ground.filter(([x]) => x > from && x < to);
      this.polygon([[from, heightOf(world.ground, from)], ...inner, [to, heightOf(world.ground, to)]]);
      this.pen.strokeStyle = friction < world.friction ? this.theme.slippery : this.theme.rough;
      this.pen.lineWidth = 4;
      this.pen.stroke();
      const x = (Math.max(from, this.left) + Math.min(to, this.right)) / 2;
      if (to > this.left && from < this.right)
        this.text('friction ' + friction, this.x(x), this.y(heightOf(world.ground, x)) + 18, 'center');
    }

    /** What flows and pulls, as arrows in the upper right corner. */
    arrows(world, step) {
      let y = 26;
      const flow = flowAt(world, step), speed = Math.hypot(...flow);
      if (speed > 0) y = this.arrow(flow, 'flow ' + speed.toPrecision(2) + ' cells/t.u.', y);
      const tilt = (world.gravity_direction * turn) / 360;
      if (world.gravity > 0 && tilt) this.arrow([Math.sin(tilt), -Math.cos(tilt)], 'gravity ' + world.gravity, y);
    }

    arrow([dx, dy], words, y) {
      const { pen } = this, x = this.size.width - 30, length = Math.hypot(dx, dy), reach = 14;
      const ux = (dx / length) * reach, uy = (-dy / length) * reach;
      pen.strokeStyle = pen.fillStyle = this.theme.muted;
      pen.lineWidth = 2;
      pen.beginPath();
      pen.moveTo(x - ux, y - uy);
      pen.lineTo(x + ux * 0.5, y + uy * 0.5);
      pen.stroke();
      pen.beginPath();
      pen.moveTo(x + ux, y + uy);
      pen.lineTo(x + ux * 0.3 - uy * 0.35, y + uy * 0.3 + ux * 0.35);
      pen.lineTo(x + ux * 0.3 + uy * 0.35, y + uy * 0.3 - ux * 0.35);
      pen.fill();
      this.text(words, x - 24, y + 4, 'right');
      return y + 36;
    }

    scaleBar() {
      const cells = round(130 / this.camera.scale), width = cells * this.camera.scale;
      const x = 16, y = this.size.height - 18, { pen } = this;
      pen.strokeStyle = this.theme.ink;
      pen.lineWidth = 2;
      pen.beginPath();
      pen.moveTo(x, y - 4);
      pen.lineTo(x, y);
      pen.lineTo(x + width, y);
      pen.lineTo(x + width, y - 4);
      pen.stroke();
      pen.font = '12px system-ui, sans-serif';
      pen.textAlign = 'center';
      pen.fillStyle = this.theme.ink;
      pen.fillText(cells === 1 ? '1 cell' : cells + ' cells', x + width / 2, y - 8);
    }

    // ---- The body --------------------------------------------------------------------------------------------------

    way({ path, from, to }) {
      const { pen } = this;
      pen.beginPath();
      for (let i = from; i <= to; ++i) pen.lineTo(this.x(path.x[i]), this.y(path.y[i]));
      pen.strokeStyle = this.theme.way;
      pen.lineWidth = 1.75;
      pen.lineJoin = 'round';
      pen.stroke();
      pen.beginPath();
      pen.arc(this.x(path.x[from]), this.y(path.y[from]), 4, 0, turn);
      pen.fillStyle = this.theme.air;
      pen.fill();
      pen.stroke();
    }

    /** One colour over all nodes and links, `more` pixels wider than these: a body, or its rim. */
    mass(state, colour, more) {
      const { pen } = this, radius = this.look.radius * this.camera.scale;
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineCap = 'round';
      for (const [a, b] of state.links) {
        pen.lineWidth = 2 * (radius * 0.8 * Math.min(this.sizeOf(state, a), this.sizeOf(state, b)) + more);
        pen.beginPath();
        pen.moveTo(this.x(state.x[a]), this.y(state.y[a]));
        pen.lineTo(this.x(state.x[b]), this.y(state.y[b]));
        pen.stroke();
      }
      for (let node = 0; node < state.x.length; ++node) this.disc(state, node, radius * this.sizeOf(state, node) + more);
    }

    sizeOf(state, node) { return state.size ? state.size[node] : 1; }

    disc(state, node, radius) {
      this.pen.beginPath();
      this.pen.arc(this.x(state.x[node]), this.y(state.y[node]), radius, 0, turn);
      this.pen.fill();
    }

    links(state) {
      const { pen } = this;
      pen.strokeStyle = this.theme.link;
      pen.lineWidth = Math.max(0.75, 0.05 * this.camera.scale);
      pen.beginPath();
      for (const [a, b] of state.links) {
        pen.moveTo(this.x(state.x[a]), this.y(state.y[a]));
        pen.lineTo(this.x(state.x[b]), this.y(state.y[b]));
      }
      pen.stroke();
    }

    body(state) {
      const { pen, look, theme } = this, radius = look.radius * this.camera.scale;
      if (look.outline) this.mass(state, theme.rim, Math.max(1.25, 0.07 * this.camera.scale));
      this.mass(state, theme.body, 0);
      for (let node = 0; node < state.x.length; ++node) {
        pen.fillStyle = node >= state.cells ? theme.object : look.colours ? look.colours[node] : theme.plain;
        this.disc(state, node, radius * 0.86 * this.sizeOf(state, node));
      }
      if (look.links) this.links(state);
      const chosen = state.ids.indexOf(look.chosen);
      if (chosen < 0) return;
      pen.beginPath();
      pen.arc(this.x(state.x[chosen]), this.y(state.y[chosen]), radius * this.sizeOf(state, chosen) + 1, 0, turn);
      pen.strokeStyle = theme.ink;
      pen.lineWidth = 5;
      pen.stroke();
      pen.strokeStyle = theme.chosen;
      pen.lineWidth = 3;
      pen.stroke();
    }
  }

  /** The velocity of the fluid, cells/t.u. */
  function flowAt(world, step) {
    if (!world.current) return world.flow;
    const { samples, repeats } = world.current, at = (step - world.first_step) / world.current.step, low = Math.floor(at);
    const sample = (i) => samples[repeats ? i % samples.length : Math.min(i, samples.length - 1)];
    const a = sample(Math.max(0, low)), b = sample(Math.max(0, low) + 1);
    return [0, 1].map((axis) => a[axis] + (at - low) * (b[axis] - a[axis]));
  }

  planula.drawScene = function (pen, size, state, world, camera, look) {
    const scene = new Scene(pen, size, camera, look);
    scene.backdrop(world);
    scene.grid();
    if (world) scene.regions(world, false), scene.ground(world), scene.regions(world, true);
    if (look.way) scene.way(look.way);
    scene.body(state);
    if (world) scene.arrows(world, state.step);
    scene.scaleBar();
  };
})();
