// SPDX-License-Identifier: MIT
// Reads recordings (core/recording/recording_json.h says what their text holds) into arrays that the viewer draws from.
//
//   planula.unpack(text)      a promise of the object behind a compressed text of a page: JSON, gzip, Base64
//   planula.open(recording)   the arrays of a parsed recording
'use strict';
var planula = globalThis.planula || {};
globalThis.planula = planula;

(function () {
  const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
  const digits = new Int8Array(128).fill(-1);
  for (let i = 0; i < alphabet.length; ++i) digits[alphabet.charCodeAt(i)] = i;

  /** Series of numbers, one after the other, from a text in Base64 VLQ (core/recording/packed_numbers.h). */
  class Numbers {
    constructor(text, scale) {
      this.text = text;
      this.scale = scale;
      this.at = 0;
    }

    next() {
      let value = 0, factor = 1, digit;
      do {
        digit = digits[this.text.charCodeAt(this.at++)];
        if (!(digit >= 0)) throw new Error('the recording is damaged: its numbers end early');
        value += (digit & 31) * factor;
        factor *= 32;
      } while (digit & 32);
      const magnitude = Math.floor(value / 2);
      return value % 2 ? -magnitude : magnitude;
    }

    /** The next `length` numbers, summed up `order` times, in units of 1. */
    series(length, order) {
      const sums = new Float64Array(length);
      for (let i = 0; i < length; ++i) sums[i] = this.next();
      for (let pass = 0; pass < order; ++pass)
        for (let i = 1; i < length; ++i) sums[i] += sums[i - 1];
      return Float32Array.from(sums, (value) => value / this.scale);
    }
  }

  /** Groups of a flat list: groups([1, 2, 3, 4], 2) is [[1, 2], [3, 4]]. */
  function groups(list, size) {
    const all = [];
    for (let at = 0; at < list.length; at += size) all.push(list.slice(at, at + size));
    return all;
  }

  function openGrowth(recording) {
    const { growth, scales } = recording;
    const numbers = new Numbers(growth.positions, scales.position);
    const cells = groups(growth.cells, 3).map(([id, first, end]) => ({
      id, first, end, x: numbers.series(end - first, 2), y: numbers.series(end - first, 2),
    }));
    const links = groups(growth.links, 4).map(([a, b, first, end]) => ({ a, b, first, end }));
    return { steps: growth.steps, cells, links };
  }

  /** What moves: of each body its frames, and of each of its nodes the places in these. */
  function openBodies(recording) {
    const { gait, bodies, object, scales } = recording;
    const places = new Numbers(gait.positions, scales.position);
    const signals = new Numbers(gait.signals, scales.signal);
    const compressions = new Numbers(gait.compressions, scales.compression);
    return bodies.map((body, number) => {
      const first = body.first_frame;
      const end = number + 1 < bodies.length ? bodies[number + 1].first_frame : gait.steps.length;
      const muscles = gait.muscle_frames.filter((frame) => frame >= first && frame < end);
      const cells = body.ids.length, nodes = first < end ? cells + (object ? object.nodes : 0) : 0;
      const opened = {
        first, end, cells, ids: body.ids, links: groups(body.links, 2), outline: groups(body.outline, 2),
        x: [], y: [], muscleSteps: muscles.map((frame) => gait.steps[frame]), signals: [], pressures: [],
      };
      for (let node = 0; node < nodes; ++node) {
        opened.x.push(places.series(end - first, 2));
        opened.y.push(places.series(end - first, 2));
      }
      for (let cell = 0; cell < cells && muscles.length; ++cell) {
        opened.signals.push(signals.series(muscles.length, 2));
        opened.pressures.push(
          compressions.series(muscles.length, 2).map((share) => share * recording.pressure_stiffness));
      }
      return opened;
    });
  }

  /** Updates of all cells' networks: by a cell's id its activations, a row per node. */
  function openUpdates(updates, nodes, scale) {
    const numbers = new Numbers(updates.values, scale);
    const cells = new Map();
    for (const [id, first, end] of groups(updates.cells, 3)) {
      const rows = [];
      for (let node = 0; node < nodes; ++node) rows.push(numbers.series(end - first, 1));
      cells.set(id, { first, end, rows });
    }
    return { steps: updates.steps, cells };
  }

  planula.open = function (recording) {
    if (recording.format !== 'planula recording 1')
      throw new Error('this page cannot play a recording of the format "' + recording.format + '"');
    const { network, scales } = recording, nodes = network.nodes.length;
    return {
      about: recording,
      growth: openGrowth(recording),
      gait: { steps: recording.gait.steps, bodies: openBodies(recording) },
      network: {
        nodes: network.nodes, links: network.links,
        growth: openUpdates(network.growth, nodes, scales.activation),
        gait: openUpdates(network.gait, nodes, scales.activation),
      },
    };
  };

  planula.unpack = async function (text) {
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return JSON.parse(await new Response(stream).text());
  };
})();
