// SPDX-License-Identifier: MIT
// The page of a report: reads what it holds, and builds its sections.
import { Report } from './data.js';
import { make } from './dom.js';
import { fitness, overview, searches } from './overview.js';
import { archive, exploration } from './exploration.js';
import { heredity, outcomes, sizes, species } from './populations.js';
import { claims, ownTables } from './claims.js';
import { gallery, individualWindow } from './champions.js';
import { method, provenance } from './method.js';

const text = (id) => document.getElementById(id).textContent;

function contents(sections) {
  return make('nav', { 'aria-label': 'Contents' }, make('ol', {}, sections.map((section) =>
    make('li', {}, make('a', { href: `#${section.id}` }, section.querySelector('h2').textContent)))));
}

/** Marks in the contents the section that is read. */
function follow(sections, nav) {
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const link = nav.querySelector(`a[href="#${entry.target.id}"]`);
      if (entry.isIntersecting) {
        nav.querySelectorAll('[aria-current]').forEach((other) => other.removeAttribute('aria-current'));
        link.setAttribute('aria-current', 'true');
      }
    }
  }, { rootMargin: '-15% 0px -75% 0px' });
  sections.forEach((section) => observer.observe(section));
}

async function build() {
  const report = new Report(await globalThis.planula.unpack(text('data')));
  const sections = [overview, gallery, fitness, searches, exploration, species, archive, sizes, heredity, outcomes, claims, ownTables, method]
    .map((make) => make(report)).concat(provenance(report, text('licences'))).filter(Boolean);
  const nav = contents(sections);
  document.getElementById('report').replaceChildren(nav, make('div', { class: 'sections' }, sections));
  individualWindow(report);
  follow(sections, nav);
  document.documentElement.dataset.ready = '';
}

build().catch((error) => {
  document.getElementById('report').replaceChildren(make('p', { class: 'absent' }, `The page cannot be shown: ${error.message}. A browser of 2023 or later is needed.`));
  throw error;
});
