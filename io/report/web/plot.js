// Curves over frequency with a cursor, zoom and linear or logarithmic axes (uPlot).
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

import { element } from './element.js';

// Those of Okabe and Ito, which differ in lightness too.
const colours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9'];
const dashes = [[], [8, 5], [2, 4], [10, 4, 2, 4]];
const borders = ['solid', 'dashed', 'dotted', 'dashed']; // of the lines in the legend
const height = 340;

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const digits = (value) => (value == null ? '–' : Number(value.toPrecision(4)).toString());

// What stands beside an axis, where "0.000001" would run into its title.
const tick = (value) => (value == null ? ''
  : value !== 0 && Math.abs(value) < 1e-3 ? Number(value.toPrecision(4)).toExponential()
    : digits(value));

// What the page says of a plot: { label, abscissa, ordinate, linear, range, step, grids: [[x]], curves:
// [{ name, grid, colour, dashes, faint, values }], marks: [[x, order, filled]], verticals: [x] }.
// A curve may turn back on itself
// (a response that jumps), so it is drawn from its own points; the table below is for the cursor.
function path(x, y) {
  return (plot, index) => {
    const line = new Path2D();
    let open = false;
    for (let i = 0; i < x.length; ++i) {
      if (y[i] == null || (plot.scales.y.distr === 3 && !(y[i] > 0))) { open = false; continue; }
      const at = [plot.valToPos(x[i], 'x', true), plot.valToPos(y[i], 'y', true)];
      if (open) line.lineTo(...at); else line.moveTo(...at);
      open = true;
    }
    return { stroke: line, fill: null, clip: null, flags: 0, index };
  };
}

// Values of a curve at frequencies in rising order, between its points; null beyond its ends.
function sampled(x, y, at) {
  const order = [...x.keys()].filter((i) => y[i] != null).sort((i, j) => x[i] - x[j]);
  let k = 0;
  return at.map((f) => {
    while (k + 1 < order.length && x[order[k + 1]] <= f) ++k;
    const i = order[k];
    const j = order[k + 1] ?? i;
    if (i === undefined || f < x[i] || (j === i && f > x[i])) return null;
    return x[j] > x[i] ? y[i] + ((y[j] - y[i]) * (f - x[i])) / (x[j] - x[i]) : y[i];
  });
}

function table(data) {
  const all = [...new Set(data.grids.flat())].sort((a, b) => a - b);
  return [all, ...data.curves.map((c) => sampled(data.grids[c.grid], c.values, all))];
}

function series(data) {
  return data.curves.map((curve) => ({
    label: curve.name,
    stroke: curve.faint ? style('--muted') : colours[curve.colour % colours.length],
    width: curve.faint ? 1 : 1.75,
    dash: dashes[curve.dashes % dashes.length],
    points: { show: false },
    paths: path(data.grids[curve.grid], curve.values),
    value: (_, v) => digits(v),
  }));
}

// Lines down to the axis, and marks at heights of their own.
function furnish(data) {
  return (plot) => {
    const { ctx, bbox } = plot;
    const top = Math.max(1, ...data.marks.map((m) => m[1]));
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = style('--ink');
    ctx.lineWidth = devicePixelRatio;
    const inside = (f) => f >= plot.scales.x.min && f <= plot.scales.x.max;
    for (const f of data.verticals.filter(inside)) {
      const x = plot.valToPos(f, 'x', true);
      ctx.globalAlpha = 0.35;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    for (const [f, order, filled] of data.marks.filter((m) => inside(m[0]))) {
      ctx.globalAlpha = filled ? 0.9 : 0.45;
      ctx.beginPath();
      ctx.arc(plot.valToPos(f, 'x', true), bbox.top + bbox.height * (1 - order / top),
        2.4 * devicePixelRatio, 0, 2 * Math.PI);
      if (filled) ctx.fill(); else ctx.stroke();
    }
    ctx.restore();
  };
}

// Curves without a name are not in the legend.
function onlyNamed(data) {
  return (plot) => {
    const rows = plot.root.querySelectorAll('.u-legend .u-series');
    data.curves.forEach((curve, i) => { if (!curve.name && rows[i + 1]) rows[i + 1].hidden = true; });
  };
}

function options(data, width, logarithmic) {
  const axis = {
    stroke: style('--ink'),
    grid: { stroke: style('--rule'), width: 1 },
    ticks: { stroke: style('--rule') },
    font: '12px system-ui, sans-serif',
  };
  return {
    width,
    height,
    cursor: { drag: { x: true, y: false }, focus: { prox: 24 } },
    focus: { alpha: 0.45 },
    // The line of each curve, as CSS draws it from its border.
    legend: { live: true, markers: { fill: () => 'transparent',
      dash: (_, i) => borders[(data.curves[i - 1]?.dashes ?? 0) % borders.length] } },
    scales: {
      x: { time: false, distr: logarithmic.x ? 3 : 1 },
      y: { distr: logarithmic.y ? 3 : 1, ...(data.range && { range: data.range }) },
    },
    axes: [
      { ...axis, label: data.abscissa, labelFont: axis.font, values: (_, v) => v.map((x) => tick(x)) },
      { ...axis, label: data.ordinate, labelFont: axis.font, size: 64,
        values: (_, v) => v.map((x) => tick(x)), ...(data.step > 0 && { incrs: [data.step] }) },
    ],
    hooks: { draw: [furnish(data)], ready: [onlyNamed(data)] },
    series: [{ label: data.abscissa, value: (_, v) => digits(v) }, ...series(data)],
  };
}

export function enlivenPlot(figure) {
  const source = figure.querySelector('script[type="application/json"]');
  if (!source) return;
  const data = JSON.parse(source.textContent);
  if (data.curves.length === 0) return;
  const positive = data.grids.every((grid) => grid.every((f) => f > 0));
  const logarithmic = { x: false, y: !data.linear };
  const positiveValues = data.curves.every((c) => c.values.every((v) => v == null || v > 0));
  const values = table(data);
  const stage = element('div', { className: 'live', role: 'group', ariaLabel: data.label });
  const bar = element('div', { className: 'controls', role: 'group', ariaLabel: 'axes' });
  let plot = null;
  const draw = () => {
    if (plot) plot.destroy();
    plot = new uPlot(options(data, Math.max(300, stage.clientWidth), logarithmic), values, stage);
    figure.plot = plot;
  };
  for (const [axis, text] of [['x', 'abscissa'], ['y', 'ordinate']]) {
    const button = element('button', { type: 'button', ariaPressed: String(logarithmic[axis]) },
      `${text} logarithmic`);
    button.addEventListener('click', () => {
      logarithmic[axis] = !logarithmic[axis];
      button.ariaPressed = String(logarithmic[axis]);
      draw();
    });
    if (axis === 'y' ? !data.linear || positiveValues : positive) bar.append(button);
  }
  bar.append(element('span', {},
    'drag to zoom, double click for all, a name in the legend hides its curve'));
  figure.prepend(stage, bar);
  figure.classList.add('is-live');
  draw();
  new ResizeObserver(() => {
    if (plot && stage.clientWidth > 0) plot.setSize({ width: stage.clientWidth, height });
  }).observe(stage);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
}
