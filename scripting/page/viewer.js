// SPDX-License-Identifier: MIT
// Plays a recording of a life in a page.
//
//   planula.mountReplay(element, recording, options)
//     recording   what planula.unpack() gave
//     options     {compact: true}: a small picture and a button, for galleries; {autoplay: false}
//     returns     {play(), pause(), seek(step), speed(factor), destroy()}
//
// Steps count from the zygote: those of growth, then those of locomotion. At speed 1 a second shows one time unit.
'use strict';
(function () {
  const colourings = [
    ['auto', 'birth order, then signal'], ['signal', 'muscle signal'], ['pressure', 'pressure'],
    ['birth', 'birth order'], ['none', 'nothing'],
  ];
  const speeds = [0.25, 0.5, 1, 2, 4, 8];
  const shown = { outline: 'outline', links: 'links', way: 'path of the centre of mass' };

  /** An element with attributes (functions: listeners) and children. */
  function make(tag, attributes, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {}))
      if (typeof value === 'function') made.addEventListener(name, value);
      else if (value !== false) made.setAttribute(name, value === true ? '' : value);
    made.append(...children);
    return made;
  }

  const minus = (text) => String(text).replace('-', '−');

  class Replay {
    constructor(element, recording, options) {
      this.life = planula.open(recording);
      this.about = recording;
      this.motion = planula.motion(this.life);
      this.compact = Boolean(options.compact);
      this.step = 0;
      this.factor = 1;
      this.zoom = 1;
      this.chosen = 0;
      this.colouring = 'auto';
      this.look = { outline: true, links: true, way: true };
      this.follows = true;
      this.request = 0;
      this.pressureRange = this.findPressureRange();
      this.build(element);
      this.resize = new ResizeObserver(() => this.draw());
      this.resize.observe(this.stage);
      this.scheme = matchMedia('(prefers-color-scheme: dark)');
      this.onScheme = () => { this.readTheme(); this.draw(); };
      this.scheme.addEventListener('change', this.onScheme);
      this.readTheme();
      this.draw();
      const still = this.compact || matchMedia('(prefers-reduced-motion: reduce)').matches;
      if (options.autoplay ?? !still) this.play();
    }

    // ---- What is drawn ---------------------------------------------------------------------------------------------

    readTheme() {
      const style = getComputedStyle(this.root), theme = {};
      for (const name of ['ink', 'muted', 'air', 'water-top', 'water-bottom', 'region', 'region-edge', 'grid', 'solid',
        'solid-edge', 'slippery', 'rough', 'way', 'rim', 'body', 'plain', 'object', 'link', 'chosen'])
        theme[name.replace(/-(.)/, (_, letter) => letter.toUpperCase())] = style.getPropertyValue('--pl-' + name).trim();
      this.theme = theme;
      this.isDark = style.getPropertyValue('--pl-dark').trim() === '1';
    }

    /** The pressure that 95 of 100 stay below. */
    findPressureRange() {
      const all = [];
      for (const body of this.life.gait.bodies)
        for (const series of body.pressures)
          for (let i = 0; i < series.length; i += 5) all.push(Math.abs(series[i]));
      all.sort((a, b) => a - b);
      return all[Math.floor(all.length * 0.95)] || 1;
    }

    /** What colours the cells at a state: a colour each, or null, and what the scale means. */
    colours(state) {
      let by = this.colouring;
      if (by === 'auto') by = state.stage === 'growth' || !state.signals ? 'birth' : 'signal';
      const signed = (values, range) =>
        values.map((value) => planula.palette.signed(Math.max(-1, Math.min(1, value / range)), this.isDark));
      if (by === 'birth') {
        const last = Math.max(1, this.about.births - 1);
        return { list: state.ids.map((id) => planula.palette.ordered(id / last)), scale: ['ordered', 'first', 'last born'] };
      }
      if (by === 'signal' && state.signals) return { list: signed(state.signals, 1), scale: ['signed', 'shorter', 'longer'] };
      if (by === 'pressure' && state.pressures) {
        const range = this.pressureRange, words = range.toPrecision(2);
        return { list: signed(state.pressures, range), scale: ['signed', '−' + words, words + ' mass/t.u.²'] };
      }
      if (by.startsWith('node ')) {
        const node = Number(by.slice(5)), rows = state.ids.map((id) => this.motion.activations(id, this.step));
        const list = rows.map((row) => (row ? planula.palette.signed(Math.max(-1, Math.min(1, row[node])), this.isDark) : this.theme.plain));
        return { list, scale: ['signed', '−1', '1'] };
      }
      return { list: null, scale: null };
    }

    camera(size, state) {
      const { motion } = this;
      if (this.follows) {
        const reach = motion.reach * 1.3, middle = motion.centre(this.step, 60);
        let scale = Math.min(size.width / 1.5, size.height) / 2 / reach;
        // A loose object is in the picture, too, unless it is very far.
        const away = state.x.slice(state.cells).map((x) => Math.abs(x - middle.x) + 1);
        if (away.length) scale = Math.max(scale / 3, Math.min(scale, (0.48 * size.width) / Math.max(...away)));
        scale *= this.zoom;
        // On land there is more to see above the body than below it.
        const lift = this.about.worlds[0].ground ? (0.16 * size.height) / scale : 0;
        return { x: middle.x, y: middle.y + lift, scale };
      }
      const { x, y } = motion.path, none = !x.length, reach = motion.reach;
      const low = (list) => (none ? 0 : Math.min(...list)) - reach, high = (list) => (none ? 0 : Math.max(...list)) + reach;
      const box = [low(x), high(x), low(y), high(y)];
      const scale = this.zoom * Math.min(size.width / (box[1] - box[0]), size.height / (box[3] - box[2])) * 0.95;
      return { x: (box[0] + box[1]) / 2, y: (box[2] + box[3]) / 2, scale };
    }

    draw() {
      const size = { width: this.stage.clientWidth, height: this.stage.clientHeight };
      if (!size.width || !size.height) return;
      const dots = devicePixelRatio || 1, { canvas } = this;
      if (canvas.width !== Math.round(size.width * dots) || canvas.height !== Math.round(size.height * dots))
        canvas.width = Math.round(size.width * dots), canvas.height = Math.round(size.height * dots);
      const pen = canvas.getContext('2d'), state = this.motion.at(this.step), moves = state.stage === 'gait';
      pen.setTransform(dots, 0, 0, dots, 0, 0);
      const colours = this.colours(state), frame = moves ? this.life.gait.steps.findLastIndex((s) => s <= state.step) : 0;
      this.seen = { state, camera: this.camera(size, state), size };
      planula.drawScene(pen, size, state, moves ? this.motion.world(this.step) : null, this.seen.camera, {
        theme: this.theme, colours: colours.list, radius: this.about.cell_radius, links: this.look.links,
        outline: this.look.outline, way: moves && this.look.way ? { path: this.motion.path, from: 0, to: frame } : null,
        chosen: this.compact ? -1 : this.chosen,
      });
      if (!this.compact) this.panel.update(state, colours.scale, frame);
    }

    // ---- Time ------------------------------------------------------------------------------------------------------

    play() {
      if (this.request) return;
      if (this.step >= this.motion.end) this.step = 0;
      let last = performance.now();
      const rate = 1 / this.about.time_step / 1000; // steps in a millisecond
      const tick = (now) => {
        this.step += Math.min(100, now - last) * rate * this.factor;
        last = now;
        this.request = requestAnimationFrame(tick);
        if (this.step >= this.motion.end) {
          if (this.compact) this.step %= this.motion.end;
          else this.step = this.motion.end, this.pause();
        }
        this.draw();
      };
      this.request = requestAnimationFrame(tick);
      this.showPlaying(true);
    }

    pause() {
      cancelAnimationFrame(this.request);
      this.request = 0;
      this.showPlaying(false);
      this.describe();
    }

    toggle() { if (this.request) this.pause(); else this.play(); }

    seek(step) {
      this.step = Math.max(0, Math.min(this.motion.end, Number(step) || 0));
      this.draw();
      if (!this.request) this.describe();
    }

    showPlaying(plays) {
      this.button.setAttribute('aria-label', plays ? 'Pause' : 'Play');
      this.button.classList.toggle('playing', plays);
    }

    words(state) {
      const { about, motion } = this, time = (step) => (step * about.time_step).toFixed(1) + ' t.u.';
      const of = state.stage === 'growth' ? motion.growthEnd : about.gait_steps, step = Math.round(state.step);
      return { stage: state.stage === 'growth' ? 'Growth' : 'Gait', time: `step ${step} of ${of} (${time(step)})` };
    }

    describe() {
      const state = this.motion.at(this.step), { stage, time } = this.words(state);
      this.canvas.setAttribute('aria-label', `${stage}, ${time}: ${state.cells} cells` + this.distance(state));
    }

    /** ", 1.2 cells from where it rested", in locomotion. */
    distance(state) {
      if (state.stage === 'growth') return '';
      return `, ${this.motion.distance(this.step).toFixed(2)} cells from rest`;
    }

    // ---- The page --------------------------------------------------------------------------------------------------

    build(element) {
      this.canvas = make('canvas', { role: 'img', tabindex: this.compact ? false : 0 });
      this.button = make('button', { type: 'button', class: 'pl-play', click: () => this.toggle() });
      this.stage = make('div', { class: 'pl-stage' }, this.canvas);
      this.root = make('div', { class: 'planula-replay' + (this.compact ? ' compact' : '') });
      element.append(this.root);
      if (this.compact) {
        this.stage.append(this.button);
        this.root.append(this.stage);
      } else this.panel = new planula.Panel(this, make, { colourings, speeds, shown });
      this.showPlaying(false);
      this.describe();
    }

    /** The cell nearest to a place of the canvas, if one is there. */
    cellAt(left, top) {
      const { state, camera, size } = this.seen;
      let best = -1, nearest = (1.2 * this.about.cell_radius * camera.scale) ** 2;
      for (let cell = 0; cell < state.cells; ++cell) {
        const x = size.width / 2 + (state.x[cell] - camera.x) * camera.scale - left;
        const y = size.height / 2 - (state.y[cell] - camera.y) * camera.scale - top;
        if (x * x + y * y < nearest) nearest = x * x + y * y, best = state.ids[cell];
      }
      return best;
    }

    destroy() {
      cancelAnimationFrame(this.request);
      this.resize.disconnect();
      this.scheme.removeEventListener('change', this.onScheme);
      if (this.panel) document.removeEventListener('keydown', this.panel.onKey);
      this.root.remove();
    }
  }

  Object.assign(planula, { make, minus });
  planula.mountReplay = function (element, recording, options) {
    const replay = new Replay(element, recording, options || {});
    return {
      play: () => replay.play(),
      pause: () => replay.pause(),
      seek: (step) => replay.seek(step),
      speed: (factor) => { replay.factor = factor; if (replay.panel) replay.panel.showSpeed(factor); },
      destroy: () => replay.destroy(),
    };
  };
})();
