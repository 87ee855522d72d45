// SPDX-License-Identifier: MIT
// What all charts share: fonts, axes, and a curve of each setting with its interval.
import * as Plot from '@observablehq/plot';
import { shown } from './data.js';


/** A chart with this page's look. */
export function chart(width, options) {
  return Plot.plot({
    width, marginLeft: 44, marginRight: 10, marginTop: 22, marginBottom: 36,
    style: { background: 'none', color: 'var(--ink)', fontFamily: 'var(--sans)', fontSize: '12px', overflow: 'visible' },
    ...options,
  });
}

export const grid = (axis = 'y', options = {}) =>
  (axis === 'y' ? Plot.gridY : Plot.gridX)({ stroke: 'var(--grid)', strokeOpacity: 1, ...options });
export const zero = Plot.ruleY([0], { stroke: 'var(--axis)' });
export const tip = { fill: 'var(--paper)', stroke: 'var(--axis)', textPadding: 8 };

/** The largest of values; at least 0. */
export const largest = (values) => values.reduce((most, value) => (value > most ? value : most), 0);
export const smallest = (values) => values.reduce((least, value) => (value < least ? value : least), 0);

/** Ticks of generations: whole numbers, few enough for the width. */
export function generationAxis(last, width, label = 'generation') {
  return { domain: [0, Math.max(1, last)], label, labelAnchor: 'right', labelArrow: 'none', ticks: Math.max(2, Math.floor(width / 80)),
    tickFormat: (value) => (Number.isInteger(value) ? shown(value) : '') };
}

/** Marks of the curves of a group's settings. Each curve: {setting, line: [{generation, value, low, high}], runs: [{generation,
    value, seed}]}: a band where there is an interval, otherwise a thin line of each run. */
export function curveMarks(curves) {
  const marks = [];
  for (const { setting, line, runs } of curves) {
    const band = line.filter((point) => point.low !== null && point.low !== undefined);
    if (band.length)
      marks.push(Plot.areaY(band, { x: 'generation', y1: 'low', y2: 'high', fill: setting.colour, fillOpacity: 0.18 }));
    else if (runs)
      marks.push(Plot.line(runs, { x: 'generation', y: 'value', z: 'seed', stroke: setting.colour, strokeOpacity: 0.35, strokeWidth: 1 }));
  }
  for (const { setting, line } of curves)
    marks.push(line.length === 1
      ? Plot.dot(line, { x: 'generation', y: 'value', fill: setting.colour, r: 4 })
      : Plot.line(line, { x: 'generation', y: 'value', stroke: setting.colour, strokeWidth: 2.2, strokeLinejoin: 'round' }));
  const points = curves.flatMap(({ setting, line }) => line.map((point) => ({ ...point, setting })));
  marks.push(Plot.tip(points, Plot.pointer({ x: 'generation', y: 'value', ...tip, title: (point) =>
    `${point.setting.short}\ngeneration ${shown(point.generation)}\n${shown(point.value)}`
    + (point.low !== null && point.low !== undefined ? ` [${shown(point.low)}, ${shown(point.high)}]` : '') })));
  return marks;
}
