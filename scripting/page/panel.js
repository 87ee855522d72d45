// SPDX-License-Identifier: MIT
// What surrounds the picture of a replay: facts, controls, and the network of a chosen cell. viewer.js makes it.
'use strict';
(function () {
  const chartWidth = 1000, chartHeight = 44;

  /** A curve as a filled area, from x = `left` to `right`; `values` are shares of the height. */
  function area(values, left, right) {
    const x = (i) => (left + ((right - left) * i) / Math.max(1, values.length - 1)).toFixed(1);
    const points = values.map((value, i) => `L${x(i)} ${(chartHeight - value * (chartHeight - 3)).toFixed(1)}`);
    return `M${left} ${chartHeight}${points.join('')}L${right} ${chartHeight}Z`;
  }

  const signalWidth = 440, signalHeight = 74, signalSpan = 400; // pixels, pixels, steps

  planula.Panel = class {
    constructor(replay, make, lists) {
      this.replay = replay;
      this.make = make;
      const { growth, gait } = replay.life.network;
      this.isSilent = growth.steps.length + gait.steps.length === 0; // as galleries record
      const { root, stage } = replay;
      root.append(this.header(), make('div', { class: 'pl-body' },
        make('div', { class: 'pl-left' }, stage, this.timeline(), this.options(lists)), this.network()), this.footer());
      stage.append(this.badge = make('div', { class: 'pl-badge' }));
      replay.canvas.addEventListener('click', (event) => {
        const cell = replay.cellAt(event.offsetX, event.offsetY);
        if (cell >= 0) this.chooseCell(cell);
      });
      // Keys work wherever nothing else has the focus.
      this.onKey = (event) => { if (event.target === document.body || root.contains(event.target)) this.key(event); };
      document.addEventListener('keydown', this.onKey);
    }

    // ---- Parts -----------------------------------------------------------------------------------------------------

    header() {
      const { make } = this, { about } = this.replay, known = (value) => value !== null && value !== undefined;
      const names = [about.setting, known(about.seed) && 'seed ' + about.seed,
        known(about.generation) && 'generation ' + about.generation, known(about.slot) && 'slot ' + about.slot,
        'genome ' + about.genome].filter(Boolean);
      const facts = [['outcome', about.outcome.replace('_', ' ')], ['cells', about.cells],
        ['distance', about.displacement.toFixed(2) + ' cells']];
      if (known(about.fitness)) facts.push(['fitness', planula.minus(about.fitness.toFixed(2))]);
      facts.push(['muscles', about.actuation === 'grn' ? 'gene network' : 'oscillators']);
      return make('header', {},
        make('div', {}, make('h1', {}, about.title || about.setting || 'A life'), make('p', {}, names.join(' · '))),
        make('dl', {}, ...facts.map(([name, value]) =>
          make('div', {}, make('dt', {}, name), make('dd', {}, String(value))))));
    }

    /** Play, and the whole life as a curve to move along: cells while it grows, then its distance from rest. */
    timeline() {
      const { make, replay } = this, { motion, life } = replay, { path } = motion;
      const split = (chartWidth * motion.growthEnd) / motion.end;
      const counts = life.growth.steps.map((_, frame) =>
        life.growth.cells.filter((cell) => cell.first <= frame && frame < cell.end).length);
      const ways = path.steps.map((step) => motion.distance(motion.growthEnd + step));
      const shares = (list) => { const most = Math.max(1e-9, ...list); return list.map((value) => value / most); };
      const chart = make('div', { class: 'pl-chart', 'aria-hidden': 'true' });
      chart.innerHTML = `<svg viewBox="0 0 ${chartWidth} ${chartHeight}" preserveAspectRatio="none">` +
        `<path class="growth" d="${area(shares(counts), 0, split)}"/>` +
        (ways.length ? `<path class="gait" d="${area(shares(ways), split, chartWidth)}"/>` : '') + '</svg>' +
        `<span style="left:0">cells</span>` +
        (ways.length ? `<span style="left:${split / 10}%">distance from rest</span>` : '');
      this.slider = make('input', {
        type: 'range', min: 0, max: motion.end, step: 1, value: 0, 'aria-label': 'Step of the life',
        input: () => replay.seek(this.slider.value),
      });
      this.time = make('output', { class: 'pl-time' });
      return make('div', { class: 'pl-timeline' }, replay.button, make('div', { class: 'pl-track' }, chart, this.slider), this.time);
    }

    options({ colourings, speeds, shown }) {
      const { make, replay } = this;
      const choice = (value, words) => make('option', { value }, words);
      this.speed = make('select', { change: () => { replay.factor = Number(this.speed.value); } },
        ...speeds.map((each) => choice(each, each + ' t.u./s')));
      this.speed.value = '1';
      const nodes = make('optgroup', { label: 'network' },
        ...replay.life.network.nodes.map((node, i) => choice('node ' + i, node.name)));
      this.colour = make('select', { change: () => this.colourBy(this.colour.value) },
        ...colourings.map(([value, words]) => choice(value, words)), nodes);
      this.scale = make('span', { class: 'pl-scale' }, make('span'), make('i'), make('span'));
      const box = (words, isOn, change) => {
        const input = make('input', { type: 'checkbox', change: () => { change(input.checked); replay.draw(); } });
        input.checked = isOn;
        return make('label', {}, input, words);
      };
      const zoom = (factor, words, name) => make('button', {
        type: 'button', 'aria-label': name, click: () => this.zoomBy(factor),
      }, words);
      this.follow = box('follow', true, (isOn) => { replay.follows = isOn; });
      return make('div', { class: 'pl-options' },
        make('label', {}, 'speed', this.speed), make('label', {}, 'colour', this.colour), this.scale,
        make('span', { class: 'pl-boxes' }, this.follow,
          ...Object.entries(shown).map(([name, words]) => box(words, true, (isOn) => { replay.look[name] = isOn; }))),
        make('span', { class: 'pl-zoom' }, zoom(1 / 1.25, '−', 'Zoom out'), zoom(1.25, '+', 'Zoom in')));
    }

    network() {
      const { make, replay } = this;
      this.cell = make('h2', { 'aria-live': 'polite' });
      this.note = make('p', { class: 'pl-note' });
      const picture = make('div', { class: 'pl-picture' });
      const step = (by, words, name) => make('button', {
        type: 'button', 'aria-label': name, click: () => this.stepCell(by),
      }, words);
      const aside = make('aside', { class: 'pl-network' },
        make('div', { class: 'pl-cell' }, this.cell, step(-1, '‹', 'Previous cell'), step(1, '›', 'Next cell')),
        this.note, picture, this.signalChart());
      this.drawing = planula.mountNetwork(picture, replay.life.network, (node) => {
        this.colour.value = 'node ' + node;
        this.colourBy(this.colour.value);
      });
      return aside;
    }

    /** The muscles of the chosen cell around this moment. */
    signalChart() {
      const chart = this.make('div', { class: 'pl-signal', 'aria-hidden': 'true' });
      chart.innerHTML = '<p></p>' + `<svg viewBox="0 0 ${signalWidth} ${signalHeight}"><path class="axis" d="M0 ${signalHeight / 2}H${signalWidth}"/>` +
        `<path class="now" d="M${signalWidth / 2} 0V${signalHeight}"/><path class="curve"/></svg>`;
      [this.signalWords] = chart.children;
      this.signalCurve = chart.querySelector('.curve');
      return this.signalBox = chart;
    }

    showSignal(state) {
      const { replay } = this, cell = state.ids.indexOf(replay.chosen);
      this.signalBox.hidden = !state.signals || cell < 0;
      if (this.signalBox.hidden) return;
      const points = [];
      for (const body of replay.life.gait.bodies) {
        const place = body.ids.indexOf(replay.chosen);
        if (place < 0) continue;
        body.muscleSteps.forEach((step, i) => {
          const x = (step - state.step) / signalSpan + 0.5;
          if (x > -0.05 && x < 1.05)
            points.push(`${(x * signalWidth).toFixed(1)} ${((1 - body.signals[place][i] * 0.92) * signalHeight / 2).toFixed(1)}`);
        });
      }
      this.signalCurve.setAttribute('d', 'M' + points.join('L'));
      this.signalWords.textContent = `muscle signal ${planula.minus(state.signals[cell].toFixed(2))}, 200 steps before and after`;
    }

    footer() {
      const { make, replay } = this, { about } = replay, shift = about.settle_steps;
      const { ground, obstacles, ceiling } = about.worlds[0];
      const words = ['Keys: space plays, ← → ten steps, home and end, [ ] another cell, + − zoom.'];
      if (ground || ceiling || obstacles.length) words.unshift('Cells touch ground and walls with their centres.');
      if (shift > 0) words.unshift(`Between growth and gait it settled for ${shift} steps, which are not shown.`);
      return make('footer', {}, make('p', {}, words.join(' ')),
        make('p', { class: 'pl-hash', title: 'SHA-256 of every field of the life' }, 'life ', make('code', {}, about.life)));
    }

    // ---- What the reader does --------------------------------------------------------------------------------------

    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey || /^(SELECT)$/.test(event.target.tagName)) return;
      const isControl = /^(BUTTON|INPUT)$/.test(event.target.tagName), { replay } = this, leap = 10;
      const actions = {
        '[': () => this.stepCell(-1), ']': () => this.stepCell(1), '+': () => this.zoomBy(1.25), '-': () => this.zoomBy(1 / 1.25),
      };
      if (!isControl) Object.assign(actions, {
        ' ': () => replay.toggle(), ArrowLeft: () => replay.seek(replay.step - leap),
        ArrowRight: () => replay.seek(replay.step + leap), Home: () => replay.seek(0), End: () => replay.seek(replay.motion.end),
      });
      const action = actions[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    }

    zoomBy(factor) {
      this.replay.zoom = Math.max(0.2, Math.min(8, this.replay.zoom * factor));
      this.replay.draw();
    }

    colourBy(colouring) {
      this.replay.colouring = colouring;
      this.drawing.choose(colouring.startsWith('node ') ? Number(colouring.slice(5)) : -1);
      this.replay.draw();
    }

    chooseCell(id) {
      this.replay.chosen = id;
      this.replay.draw();
    }

    /** To another cell of those that are there. */
    stepCell(by) {
      const { ids } = this.replay.seen.state, at = ids.indexOf(this.replay.chosen), count = ids.length;
      this.chooseCell(ids[at < 0 ? 0 : (at + by + count) % count]);
    }

    showSpeed(factor) { this.speed.value = String(factor); }

    // ---- What a moment shows ---------------------------------------------------------------------------------------

    update(state, scale) {
      const { replay } = this, { stage, time } = replay.words(state);
      this.slider.value = replay.step;
      this.slider.setAttribute('aria-valuetext', `${stage}, ${time}`);
      this.time.textContent = `${stage}, ${time}`;
      this.badge.textContent = `${state.cells} ${state.cells === 1 ? 'cell' : 'cells'}` + replay.distance(state);
      this.showScale(scale);
      this.showSignal(state);
      const activations = state.ids.includes(replay.chosen) ? replay.motion.activations(replay.chosen, replay.step) : null;
      this.drawing.show(activations, replay.isDark);
      const title = 'Network of cell ' + replay.chosen;
      if (this.cell.textContent !== title) this.cell.textContent = title;
      this.note.textContent = this.noteOn(state, activations);
    }

    noteOn(state, activations) {
      const { about, chosen } = this.replay;
      if (!state.ids.includes(chosen)) return 'This cell does not live now. Choose one in the picture.';
      if (!activations) return this.isSilent ? 'The recording holds no activations.' : 'Its network has not been read yet.';
      if (state.stage === 'growth') return 'As of its newest decision. Choose a cell in the picture, or a node to colour by.';
      if (about.actuation === 'grn') return 'As of its newest update; it goes on in the moving body.';
      return 'As at the end of growth, where its oscillator was read; it is not updated any more.';
    }

    showScale(scale) {
      this.scale.hidden = !scale;
      if (!scale) return;
      const [low, bar, high] = this.scale.children;
      low.textContent = scale[1];
      high.textContent = scale[2];
      const gradient = planula.palette.gradient(scale[0], this.replay.isDark);
      if (this.gradient !== gradient) bar.style.background = this.gradient = gradient;
    }
  };
})();
