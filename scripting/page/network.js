// SPDX-License-Identifier: MIT
// Draws a network: inputs on the left, outputs on the right, hidden nodes between them by their depth. A link is the
// wider the stronger, blue if its weight is positive and red if it is negative, dashed if it is recurrent. Nodes show
// the activations of one cell.
//
//   planula.mountNetwork(element, network)     network: that of planula.open()
//     returns {show(activations, isDark), choose(node)}; activations: one per node, or null
'use strict';
(function () {
  const width = 440, row = 26, top = 12, left = 142, right = width - 150, radius = 7, clear = 17;
  const svg = (name, attributes) => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key of Object.keys(attributes)) made.setAttribute(key, attributes[key]);
    return made;
  };

  /** The place of each node: terminals in columns, hidden ones at the mean height of their neighbours, apart. */
  function layout({ nodes, links }) {
    const kinds = (test) => nodes.map((node, i) => i).filter((i) => test(nodes[i]));
    const inputs = kinds((node) => node.kind === 'input' || node.kind === 'bias');
    const outputs = kinds((node) => node.kind === 'output'), hidden = kinds((node) => node.kind === 'hidden');
    const bottom = top + row * (Math.max(inputs.length, outputs.length, 4) - 1), places = [];
    const column = (list, x) => list.forEach((node, i) => {
      places[node] = { x, y: top + ((bottom - top) * (i + 0.5)) / list.length };
    });
    column(inputs, left);
    column(outputs, right);
    // The depths that there are, evenly: evolved ones halve again and again.
    const depths = [...new Set(hidden.map((node) => nodes[node].depth))].sort((a, b) => a - b);
    for (const node of hidden)
      places[node] = {
        x: left + ((right - left) * (depths.indexOf(nodes[node].depth) + 1)) / (depths.length + 1),
        y: (top + bottom) / 2,
      };
    for (let sweep = 0; sweep < 8; ++sweep)
      for (const node of hidden) {
        let sum = 0, weights = 0;
        for (const [from, to, weight] of links) {
          if (from === to || (from !== node && to !== node)) continue;
          const strength = Math.abs(weight) + 0.1;
          sum += strength * places[from === node ? to : from].y;
          weights += strength;
        }
        if (weights) places[node].y = sum / weights;
      }
    for (let push = 0; push < 200; ++push)
      hidden.forEach((a, i) => {
        for (const b of hidden.slice(i + 1)) {
          const dx = places[b].x - places[a].x, dy = places[b].y - places[a].y;
          if (Math.abs(dx) >= clear || Math.abs(dy) >= clear) continue;
          const shift = ((clear - Math.abs(dy)) / 2) * (dy < 0 ? -1 : 1);
          places[a].y = Math.max(top, Math.min(bottom, places[a].y - shift));
          places[b].y = Math.max(top, Math.min(bottom, places[b].y + shift));
        }
      });
    return { places, bottom };
  }

  /** The way of a link: a loop above a node, a bow within a column, a bow below back to the left, or straight on. */
  function way(from, to) {
    const curve = (x1, y1, x2, y2, x3, y3, x4, y4) => `M${x1} ${y1}C${x2} ${y2} ${x3} ${y3} ${x4} ${y4}`;
    const across = to.x - from.x;
    if (from === to)
      return curve(from.x + 4, from.y - 6, from.x + 18, from.y - 24, from.x - 18, from.y - 24, from.x - 4, from.y - 6);
    if (Math.abs(across) < 3 * radius)
      return curve(from.x - radius, from.y, from.x - 40, from.y, to.x - 40, to.y, to.x - radius, to.y);
    if (across < 0)
      return curve(from.x, from.y + radius, from.x - 18, from.y + 42, to.x + 18, to.y + 42, to.x, to.y + radius);
    const reach = 0.45 * (across - 2 * radius);
    return curve(from.x + radius, from.y, from.x + radius + reach, from.y, to.x - radius - reach, to.y, to.x - radius, to.y);
  }

  function drawLinks(network, places, picture) {
    const strongest = Math.max(1e-9, ...network.links.map((link) => Math.abs(link[2])));
    const weakestFirst = [...network.links].sort((a, b) => Math.abs(a[2]) - Math.abs(b[2]));
    for (const [from, to, weight, recurrent] of weakestFirst) {
      const share = Math.abs(weight) / strongest;
      const path = svg('path', {
        d: way(places[from], places[to]), class: weight < 0 ? 'negative' : 'positive',
        'stroke-width': 0.5 + 3.5 * share, 'stroke-opacity': 0.22 + 0.68 * share,
      });
      if (recurrent) path.setAttribute('stroke-dasharray', '5 3');
      const title = svg('title', {});
      title.textContent = `${network.nodes[from].name} to ${network.nodes[to].name}: ${weight.toFixed(3)}` +
        (recurrent ? ', recurrent' : '');
      path.append(title);
      picture.append(path);
    }
    return strongest;
  }

  function drawNodes(network, places, picture, onChoose) {
    return network.nodes.map((node, i) => {
      const group = svg('g', { class: 'node', tabindex: 0, role: 'button', 'aria-label': 'colour cells by ' + node.name });
      const { x, y } = places[i], isOutput = node.kind === 'output', isHidden = node.kind === 'hidden';
      const disc = svg('circle', { cx: x, cy: y, r: radius });
      const title = svg('title', {});
      group.append(disc, title);
      let value = null;
      if (!isHidden) {
        const name = svg('text', { x: x + (isOutput ? 13 : -13), y: y + 4, 'text-anchor': isOutput ? 'start' : 'end' });
        name.append(document.createTextNode(node.name + ' '));
        value = svg('tspan', { class: 'value' });
        if (isOutput) name.append(value);
        else name.prepend(value);
        group.append(name);
      }
      group.addEventListener('click', () => onChoose(i));
      group.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter' && event.key !== ' ') return;
        event.preventDefault();
        event.stopPropagation();
        onChoose(i);
      });
      picture.append(group);
      return { group, disc, value, title };
    });
  }

  planula.mountNetwork = function (element, network, onChoose) {
    const { places, bottom } = layout(network), height = bottom + 32;
    const picture = svg('svg', {
      viewBox: `0 0 ${width} ${height}`, role: 'group',
      'aria-label': `network of ${network.nodes.length} nodes and ${network.links.length} links`,
    });
    const strongest = drawLinks(network, places, picture);
    const marks = drawNodes(network, places, picture, onChoose);
    const legend = svg('text', { x: (left + right) / 2, y: height - 4, 'text-anchor': 'middle', class: 'legend' });
    legend.innerHTML = '<tspan class="positive">— positive</tspan>  <tspan class="negative">— negative</tspan>' +
      '  widest: ' + strongest.toFixed(2) + (network.links.some((link) => link[3]) ? '  – – recurrent' : '');
    picture.append(legend);
    element.append(picture);
    return {
      show(activations, isDark) {
        marks.forEach(({ disc, value, title }, i) => {
          const known = activations && Number.isFinite(activations[i]);
          disc.style.fill = known ? planula.palette.signed(Math.max(-1, Math.min(1, activations[i])), isDark) : '';
          const words = known ? activations[i].toFixed(2).replace('-', '−') : '';
          if (value) value.textContent = network.nodes[i].kind === 'output' ? words : words && words + ' ';
          title.textContent = network.nodes[i].name + (known ? ': ' + words : '');
        });
      },
      choose(node) {
        marks.forEach(({ group }, i) => group.classList.toggle('chosen', i === node));
      },
    };
  };
})();
