// SPDX-License-Identifier: MIT
// Colours of the viewer. Scales are safe for colour-blind readers: blue to red over grey (after RdBu, Harrower & Brewer
// 2003), and viridis (Smith & van der Walt 2015).
'use strict';
(function () {
  const scales = {
    light: ['#1f5fa8', '#7fb0d6', '#ebe9e4', '#e79b84', '#b3242f'],
    dark: ['#58a6ec', '#356c9e', '#393c42', '#9a4a42', '#f0705f'],
    viridis: ['#440154', '#414487', '#2a788e', '#22a884', '#7ad151', '#fde725'],
  };

  function parsed(colour) {
    return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  }

  /** 256 colours evenly along these. */
  function ramp(colours) {
    const stops = colours.map(parsed);
    return Array.from({ length: 256 }, (_, i) => {
      const place = (i / 255) * (stops.length - 1), low = Math.min(Math.floor(place), stops.length - 2);
      const part = stops[low].map((value, c) => Math.round(value + (place - low) * (stops[low + 1][c] - value)));
      return 'rgb(' + part.join(',') + ')';
    });
  }
  const ramps = {};
  for (const name of Object.keys(scales)) ramps[name] = ramp(scales[name]);

  const pick = (colours, share) => colours[Math.max(0, Math.min(255, Math.round(share * 255)))];

  planula.palette = {
    /** Of a number from -1 (red) over 0 to 1 (blue). */
    signed: (value, isDark) => pick(ramps[isDark ? 'dark' : 'light'], (1 - value) / 2),
    /** Of a share from 0 to 1. */
    ordered: (share) => pick(ramps.viridis, share),
    /** The scale as a CSS gradient, its lowest value on the left. */
    gradient: (name, isDark) => {
      const colours = name === 'ordered' ? scales.viridis : scales[isDark ? 'dark' : 'light'].slice().reverse();
      return 'linear-gradient(to right,' + colours.join(',') + ')';
    },
  };
})();
