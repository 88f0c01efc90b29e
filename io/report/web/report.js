// Brings a report to life where scripts run: plots answer the cursor, the part turns and its modes
// play. Without scripts, and on paper, the drawings that the page has stay.
import { enlivenPlot } from './plot.js';
import { enlivenPart } from './viewer.js';

function start() {
  for (const figure of document.querySelectorAll('figure.plot')) enlivenPlot(figure);
  const part = document.querySelector('figure.viewer');
  if (part) enlivenPart(part);
}

if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', start);
else start();
