// SPDX-License-Identifier: MIT
// Where everything is at any step of a life: frames of a recording, and what lies between them. Steps count from the
// zygote: those of growth, then those of locomotion.
//
//   planula.motion(life)      life: what planula.open() gave
'use strict';
(function () {
  /** The last place in an ascending list whose value is at most `value`; 0 if there is none. */
  function place(list, value) {
    let low = 0, end = list.length;
    while (end - low > 1) {
      const middle = (low + end) >> 1;
      if (list[middle] <= value) low = middle;
      else end = middle;
    }
    return low;
  }

  /** How far a value lies between a place of the list and the next one, 0 to 1. */
  function share(list, at, value) {
    return at + 1 < list.length ? Math.max(0, (value - list[at]) / (list[at + 1] - list[at])) : 0;
  }

  /** A smooth curve through four values, between the middle two (Catmull & Rom 1974). */
  function smooth(a, b, c, d, t) {
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  }

  function mean(values, count) {
    let sum = 0;
    for (let i = 0; i < count; ++i) sum += values[i];
    return count ? sum / count : 0;
  }

  function growthAt(life, step) {
    const { steps, cells, links } = life.growth;
    const frame = place(steps, step), t = Math.min(1, share(steps, frame, step));
    const state = { stage: 'growth', step, ids: [], x: [], y: [], size: [], links: [] }, index = new Map();
    for (const cell of cells) {
      if (frame < cell.first || frame >= cell.end) continue;
      const at = frame - cell.first, to = frame + 1 < cell.end ? at + 1 : at;
      index.set(cell.id, state.ids.length);
      state.ids.push(cell.id);
      state.x.push(cell.x[at] + t * (cell.x[to] - cell.x[at]));
      state.y.push(cell.y[at] + t * (cell.y[to] - cell.y[at]));
      state.size.push(at === 0 && cell.first > 0 ? 0.45 + 0.55 * t : 1); // a daughter grows
    }
    for (const link of links)
      if (link.first <= frame && frame < link.end) state.links.push([index.get(link.a), index.get(link.b)]);
    state.cells = state.ids.length;
    return state;
  }

  function gaitAt(life, step) {
    const { steps, bodies } = life.gait;
    const frame = place(steps, step);
    const body = bodies.findLast((each) => each.first <= frame && each.first < each.end);
    const at = frame - body.first, last = body.end - body.first - 1;
    const t = at < last ? share(steps, frame, step) : 0;
    const between = (series) =>
      smooth(series[Math.max(0, at - 1)], series[at], series[Math.min(last, at + 1)], series[Math.min(last, at + 2)], t);
    const knot = place(body.muscleSteps, step), part = Math.min(1, share(body.muscleSteps, knot, step));
    const straight = (series) =>
      series[knot] + part * (series[Math.min(series.length - 1, knot + 1)] - series[knot]);
    return {
      stage: 'gait', step, ids: body.ids, cells: body.cells, x: body.x.map(between), y: body.y.map(between),
      size: null, links: body.links, outline: body.outline,
      signals: body.signals.length ? body.signals.map(straight) : null,
      pressures: body.pressures.length ? body.pressures.map(straight) : null,
    };
  }

  /** The centre of mass of the cells in each frame of locomotion. */
  function pathOf(life) {
    const path = { steps: life.gait.steps, x: [], y: [] };
    for (const body of life.gait.bodies)
      for (let at = 0; at < body.end - body.first; ++at) {
        path.x.push(mean(body.x.map((series) => series[at]), body.cells));
        path.y.push(mean(body.y.map((series) => series[at]), body.cells));
      }
    return path;
  }

  /** How far from their centre cells reach, in growth and in locomotion. */
  function reachOf(life, path) {
    let farthest = 1;
    const look = (x, y, cx, cy) => { farthest = Math.max(farthest, Math.hypot(x - cx, y - cy)); };
    const grown = growthAt(life, Infinity), gx = mean(grown.x, grown.cells), gy = mean(grown.y, grown.cells);
    grown.x.forEach((x, cell) => look(x, grown.y[cell], gx, gy));
    for (const body of life.gait.bodies)
      for (let at = 0; at < body.end - body.first; at += 4)
        for (let cell = 0; cell < body.cells; ++cell)
          look(body.x[cell][at], body.y[cell][at], path.x[body.first + at], path.y[body.first + at]);
    return farthest + life.about.cell_radius;
  }

  planula.motion = function (life) {
    const growthEnd = life.growth.steps.at(-1), moves = life.gait.steps.length > 0;
    const path = pathOf(life);
    const grown = growthAt(life, Infinity);
    // Where the zygote is drawn: so that the grown body lies where it rests.
    const shift = moves ? { x: path.x[0] - mean(grown.x, grown.cells), y: path.y[0] - mean(grown.y, grown.cells) }
      : { x: 0, y: 0 };
    return {
      growthEnd, end: Math.max(1, growthEnd + (moves ? life.gait.steps.at(-1) : 0)), path, reach: reachOf(life, path),

      /** Everything that is drawn at a step. */
      at(step) {
        if (step >= growthEnd && moves) return gaitAt(life, step - growthEnd);
        const state = growthAt(life, step);
        state.x = state.x.map((x) => x + shift.x);
        state.y = state.y.map((y) => y + shift.y);
        return state;
      },

      /** The centre of mass; `window` steps around the step are averaged. */
      centre(step, window) {
        if (step < growthEnd || !moves) {
          const state = this.at(step);
          return { x: mean(state.x, state.cells), y: mean(state.y, state.cells) };
        }
        const from = place(path.steps, step - growthEnd - window), to = place(path.steps, step - growthEnd + window);
        const part = (list) => mean(list.slice(from, to + 1), to + 1 - from);
        if (window > 0) return { x: part(path.x), y: part(path.y) };
        const t = share(path.steps, from, step - growthEnd), next = Math.min(from + 1, path.steps.length - 1);
        return { x: path.x[from] + t * (path.x[next] - path.x[from]), y: path.y[from] + t * (path.y[next] - path.y[from]) };
      },

      /** How far the centre of mass has come, cells; jumps of it, where cells are lost or the world changes, do not count. */
      distance(step) {
        const { path: points, path_interval: interval, bodies, worlds } = life.about, local = step - growthEnd;
        if (bodies.length + worlds.length === 2 || !points.length) {
          const { x, y } = this.centre(step, 0);
          return Math.hypot(x - path.x[0], y - path.y[0]);
        }
        const at = Math.max(0, Math.min(points.length - 2, Math.floor(local / interval)));
        const t = Math.min(1, local / interval - at), [a, b] = [points[at], points[at + 1] || points[at]];
        return Math.hypot(a[0] + t * (b[0] - a[0]) - points[0][0], a[1] + t * (b[1] - a[1]) - points[0][1]);
      },

      /** The world that the body is in. */
      world(step) {
        return life.about.worlds.findLast((each) => each.first_step <= Math.max(0, step - growthEnd));
      },

      /** A cell's activations, one per node, after the newest update of its network; null if there was none. */
      activations(id, step) {
        const { growth, gait } = life.network;
        const { steps, cells } = step >= growthEnd && gait.steps.length ? gait : growth;
        const local = cells === gait.cells ? step - growthEnd : step;
        const cell = cells.get(id);
        if (!cell || !steps.length || steps[0] > local) return null;
        const update = place(steps, local);
        if (update < cell.first || update >= cell.end) return null;
        return cell.rows.map((row) => row[update - cell.first]);
      },
    };
  };
})();
