// SPDX-License-Identifier: MIT
// Simulates a life again in the reader's browser, by the core itself as WebAssembly (scripting/wasm), and compares it
// with the record by its hash. Sliders change the conditions; what comes then is not the recorded life, and is marked.
//
//   planula.mountLaboratory(element, recording, module, show)
//     recording   what planula.unpack() gave
//     module      the text of the module, build/wasm/planula.js
//     show        show(recording) plays a life in place of the one that is shown
//     returns     {simulate(): a promise of the simulated recording, destroy()}
'use strict';
(function () {
  const program = `
    const ready = planulaModule();
    onmessage = async ({ data }) => {
      let core;
      try {
        core = await ready;
        const began = performance.now();
        const text = core.ccall('simulate', 'string', ['string', 'string', 'number'], [data.genome, data.conditions, 0]);
        postMessage({ text, milliseconds: performance.now() - began });
      } catch (error) {
        // What C++ throws arrives as an address.
        const isThrown = core && typeof error === 'number';
        postMessage({ error: isThrown ? core.ccall('message_of', 'string', ['number'], [error]) : String(error) });
      }
    };`;

  /** The core in a thread of its own, so that the page stays responsive. */
  class Core {
    constructor(module) {
      this.address = URL.createObjectURL(new Blob([module, program], { type: 'text/javascript' }));
    }

    /** A promise of the recording of a life from texts, and of its time. One call at a time. */
    simulate(genome, conditions) {
      this.worker ??= new Worker(this.address);
      return new Promise((resolve, reject) => {
        const fail = (message) => { this.stop(); reject(new Error(message)); };
        this.worker.onmessage = ({ data }) => {
          if (data.error) fail(data.error);
          else resolve({ recording: JSON.parse(data.text), milliseconds: data.milliseconds });
        };
        this.worker.onerror = (event) => fail(event.message || 'the module does not start in this browser');
        this.worker.postMessage({ genome, conditions });
      });
    }

    stop() {
      this.worker?.terminate();
      this.worker = null;
    }

    destroy() {
      this.stop();
      URL.revokeObjectURL(this.address);
    }
  }

  // ---- Conditions as text: lines of a name and numbers ---------------------------------------------------------------

  /** What a slider scales: the numbers of these lines, from a place on, wherever they stand. */
  const quantities = [
    { name: 'gravity', lines: { gravity: 0 }, unit: 'cells/t.u.²' },
    { name: 'friction', lines: { friction: 0, patch: 2 }, unit: '' },
    { name: 'drag', lines: { drag_normal: 0, drag_tangential: 0 }, unit: 'mass/cell²' },
    { name: 'period', lines: { period_shortest: 0, period_longest: 0 }, unit: 'steps', actuation: 'oscillator' },
  ];

  function numbersOf(conditions, { lines }) {
    const found = [];
    for (const line of conditions.split('\n')) {
      const [name, ...words] = line.split(' ');
      if (name in lines) found.push(...words.slice(lines[name]).map(Number).filter(Number.isFinite));
    }
    return found;
  }

  function scaled(conditions, { lines }, factor) {
    const number = (word) => (Number.isFinite(Number(word)) ? String(Number(word) * factor) : word);
    return conditions.split('\n').map((line) => {
      const [name, ...words] = line.split(' ');
      if (!(name in lines)) return line;
      return [name, ...words.map((word, at) => (at < lines[name] ? word : number(word)))].join(' ');
    }).join('\n');
  }

  const shown = (value) => planula.minus(Number(value.toPrecision(3)));

  // ---- The page ------------------------------------------------------------------------------------------------------

  class Laboratory {
    constructor(element, recording, module, show) {
      Object.assign(this, { recording, show, core: new Core(module), source: recording.source });
      this.asked = 0;
      this.running = Promise.resolve();
      const actuation = this.source.conditions.match(/^actuation (\w+)/m)[1];
      this.sliders = quantities.filter((each) => !each.actuation || each.actuation === actuation)
        .map((each) => ({ ...each, numbers: numbersOf(this.source.conditions, each) }))
        .filter((each) => each.numbers.some((value) => value > 0));
      this.build(element);
    }

    build(element) {
      const { make } = planula;
      this.again = make('button', { type: 'button', class: 'pl-again', click: () => this.reset() }, 'Simulate again here');
      this.hash = make('code', {}, '—');
      this.verdict = make('p', { class: 'pl-verdict', role: 'status' });
      this.verdict.append('The core of planula runs in this page. Its result must equal the record in every bit.');
      const hashes = make('dl', { class: 'pl-hashes' },
        make('dt', {}, 'recorded life'), make('dd', {}, make('code', {}, this.recording.life)),
        make('dt', {}, 'simulated here'), make('dd', {}, this.hash));
      this.root = make('section', { class: 'planula-replay pl-laboratory', 'aria-label': 'Laboratory' },
        make('h2', {}, 'Simulate it yourself'), make('div', {}, this.again, hashes, this.verdict),
        make('fieldset', {}, make('legend', {}, 'What if? A change makes another life, which is not the recorded one.'),
          ...this.sliders.map((each) => this.slider(each))));
      element.append(this.root);
    }

    slider(each) {
      const { make } = planula;
      each.input = make('input', {
        type: 'range', min: -2, max: 2, step: 0.1, value: 0, 'aria-label': each.name,
        input: () => this.say(each), change: () => this.simulate().catch(() => {}),
      });
      each.output = make('output');
      this.say(each);
      return make('label', {}, make('span', {}, each.name), each.input, each.output);
    }

    factor(each) { return 2 ** Number(each.input.value); }

    say(each) {
      const positive = each.numbers.filter((value) => value > 0).map((value) => value * this.factor(each));
      const low = Math.min(...positive), high = Math.max(...positive);
      each.words = `${shown(low)}${high > low ? ' to ' + shown(high) : ''} ${each.unit}`.trim();
      each.output.textContent = each.words + (this.factor(each) === 1 ? ', as recorded' : '');
    }

    /** The recorded life, with all sliders back. */
    reset() {
      for (const each of this.sliders) each.input.value = 0, this.say(each);
      return this.simulate().catch(() => {});
    }

    /** A life under the conditions that the sliders state. Changes while one is simulated wait for its end. */
    async simulate() {
      const number = ++this.asked;
      await this.running.catch(() => {});
      if (number !== this.asked) return null; // a later change is simulated instead
      const changed = this.sliders.filter((each) => this.factor(each) !== 1);
      let conditions = this.source.conditions;
      for (const each of changed) conditions = scaled(conditions, each, this.factor(each));
      this.root.classList.add('busy');
      this.running = this.core.simulate(this.source.genome, conditions).then(
        (result) => this.finish(result, changed), (error) => this.fail(error));
      return this.running;
    }

    finish({ recording, milliseconds }, changed) {
      this.root.classList.remove('busy');
      const isRecorded = changed.length === 0, isEqual = recording.life === this.recording.life;
      this.hash.textContent = recording.life;
      const time = `${Math.round(milliseconds)} ms`, words = changed.map((each) => `${each.name} ${each.words}`).join(', ');
      this.judge(isRecorded ? (isEqual ? 'equal' : 'different') : 'changed',
        isRecorded
          ? isEqual ? `Equal: simulated again in ${time}, to the same bits.`
            : `Different: this browser gives another life than the record, after ${time}. That is an error of planula or of the browser.`
          : `Not the recorded life: ${words}. Simulated in ${time}.`);
      const { title, experiment, setting, seed, generation, slot, genome, fitness } = this.recording;
      const caption = isRecorded ? { title, experiment, setting, seed, generation, slot, genome, fitness }
        : { title: `Not the recorded life: ${words}`, experiment, setting, seed: null, generation: null, slot: null, genome, fitness: null };
      const life = { ...recording, ...caption };
      this.show(life);
      return life;
    }

    fail(error) {
      this.root.classList.remove('busy');
      this.hash.textContent = '—';
      this.judge('different', 'Nothing was simulated: ' + error.message);
      throw error;
    }

    judge(kind, words) {
      this.verdict.className = 'pl-verdict ' + kind;
      this.verdict.textContent = words;
    }

    destroy() {
      this.core.destroy();
      this.root.remove();
    }
  }

  planula.mountLaboratory = function (element, recording, module, show) {
    const laboratory = new Laboratory(element, recording, module, show);
    return { simulate: () => laboratory.simulate(), destroy: () => laboratory.destroy() };
  };
})();
