// The style sheet of the report: system fonts, light and dark by the reader's setting, print.
#pragma once

#include <string_view>

namespace plica {

inline constexpr std::string_view report_css = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1b2127; --muted: #5b6670;
  --rule: #d5dbe0; --strong-rule: #8c98a3; --panel: #f3f6f8; --accent: #0b5c8f; --warn: #8a4b00;
  --warn-panel: #fff6e6; --faint: #a3adb6; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #14181c; --ink: #e4e9ed; --muted: #9aa7b2; --rule: #303841;
    --strong-rule: #6b7782; --panel: #1d2329; --accent: #7cc0ec; --warn: #f0b45e;
    --warn-panel: #2b2314; --faint: #5c6873; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans",
  "Liberation Sans", Arial, sans-serif; }
main { max-width: 66rem; margin: 0 auto; padding: 2.5rem 1.5rem 3rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; font-weight: 650; letter-spacing: -0.01em; }
h2 { font-size: 1.2rem; line-height: 1.3; margin: 2.75rem 0 0.75rem; font-weight: 650; }
h3 { font-size: 1rem; margin: 1.75rem 0 0.5rem; font-weight: 600; }
p, ul { max-width: 46rem; margin: 0.5rem 0; }
ul { padding-left: 1.2rem; } li { margin: 0.3rem 0; }
code { font: 0.92em ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.case { color: var(--muted); margin: 0.35rem 0 0; }
.verdict { border-left: 4px solid var(--accent); background: var(--panel); margin: 1.5rem 0 0;
  padding: 0.7rem 1rem; max-width: none; }
.verdict.open, .warnings { border-left: 4px solid var(--warn); background: var(--warn-panel); }
.warnings { padding: 0.7rem 1rem; margin: 0.75rem 0 0; }
.warnings ul { margin: 0.2rem 0 0; max-width: none; } .verdict b, .warnings b { font-weight: 650; }
.scroll { overflow-x: auto; margin: 0.5rem 0 1.25rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.9rem; }
.note { color: var(--muted); max-width: 56rem; margin: 0 0 0.35rem; font-size: 0.875rem; }
th, td { padding: 0.32rem 0.9rem 0.32rem 0; text-align: left; vertical-align: baseline;
  border-bottom: 1px solid var(--rule); font-weight: 400; }
th:last-child, td:last-child { padding-right: 0.2rem; }
thead th { color: var(--muted); font-size: 0.8125rem; line-height: 1.25; vertical-align: bottom;
  border-bottom: 1.5px solid var(--strong-rule); }
.n { text-align: right; white-space: nowrap; } thead .n { white-space: normal; }
td + .n, th + .n { padding-left: 0.4rem; }
.unit { display: block; white-space: nowrap; }
.total th, .total td { border-bottom: 0; color: var(--muted); padding-top: 0.3rem; padding-bottom: 0; }
.nominal { background: var(--panel); }
.change { display: block; color: var(--muted); font-size: 0.8125rem; }
.faint { color: var(--faint); } .line { white-space: nowrap; } strong { font-weight: 650; }
sup { font-size: 0.7em; line-height: 0; }
.strip { width: 10rem; height: 1.25rem; vertical-align: middle; }
.strip .rail { stroke: var(--rule); stroke-width: 1; }
.strip .bar { stroke: var(--strong-rule); stroke-width: 6; }
.strip .zero { stroke: var(--ink); stroke-width: 1.25; }
.strip .dot { fill: var(--accent); stroke: var(--paper); stroke-width: 1.5; }
figure { margin: 1rem 0 1.5rem; } figure svg { display: block; width: 100%; height: auto; }
figcaption { color: var(--muted); font-size: 0.875rem; margin-top: 0.4rem; }
figcaption b { color: var(--ink); font-weight: 600; }
.drawings { display: grid; grid-template-columns: 2fr 1fr; gap: 1.5rem; align-items: end; }
.modes { display: grid; grid-template-columns: repeat(3, 1fr); gap: 0.5rem 1.5rem; }
.modes figure { margin: 0.5rem 0; min-width: 0; }
.part { max-width: 46rem; } .still { max-width: 24rem; } .pair { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); column-gap: 3rem; }
svg text { fill: var(--ink); font-family: inherit; }
.wall { fill: none; stroke: var(--ink); stroke-linejoin: round; }
.thin { fill: none; stroke: var(--muted); stroke-width: 1; }
.arrow { fill: var(--muted); stroke: none; }
.axis { stroke: var(--muted); stroke-width: 1; stroke-dasharray: 12 3 2 3; }
.ghost { fill: none; stroke: var(--muted); stroke-width: 3; stroke-dasharray: 14 12; }
.quads { fill: currentColor; stroke: currentColor; stroke-width: 1.5; stroke-linejoin: round; }
.symbol { fill: none; stroke: var(--ink); stroke-width: 5; stroke-linejoin: round; }
.body { fill: var(--faint); fill-opacity: 0.75; stroke: var(--ink); stroke-width: 4; }
.pin { fill: var(--paper); stroke: var(--ink); stroke-width: 5; }
.tag { paint-order: stroke; stroke: var(--paper); stroke-width: 10; stroke-linejoin: round; }
.legend { max-width: 22rem; }
.lines span { margin-right: 1.2em; white-space: nowrap; }
@media screen { .is-live + .lines { display: none; } }
.u-legend .u-marker { width: 2.1em !important; height: 0 !important; border-width: 2px 0 0 0 !important; vertical-align: middle; }
.first figure { margin: 0; } .first .warnings { margin: 1rem 0 0; } .first { margin-top: 1.25rem; }
.pair { align-items: start; } .pair section { min-width: 0; }
figure.plot { max-width: 54rem; } figure.is-live > svg, .is-live > .part, .is-live > .still { display: none; }
/* A drawing is as wide as its place only after its script has seen a new width. */
.live { position: relative; overflow: hidden; } .live canvas { display: block; }
.controls { display: flex; flex-wrap: wrap; gap: 0.5rem; align-items: center; margin: 0.4rem 0;
  font-size: 0.8125rem; color: var(--muted); }
.controls button, .controls select { font: inherit; color: var(--ink); background: var(--panel);
  border: 1px solid var(--strong-rule); border-radius: 4px; padding: 0.2rem 0.6rem; cursor: pointer; }
.controls button[aria-pressed="true"] { border-color: var(--accent); box-shadow: inset 0 0 0 1px var(--accent); }
.controls :focus-visible, [data-mode]:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.answer { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); column-gap: 2rem; align-items: start; }
.viewer .live { background: var(--panel); border-radius: 6px; touch-action: none; }
.live > .tag { position: absolute; left: 0; top: 0; margin: -0.7em 0 0 0.8em; font-size: 0.8125rem;
  pointer-events: none; text-shadow: 0 0 3px var(--paper), 0 0 3px var(--paper); }
.viewer .sensor::before { content: ""; position: absolute; left: -1.15em; top: 0.3em; width: 0.6em;
  height: 0.6em; border-radius: 50%; background: var(--paper); border: 2px solid var(--ink); }
.viewer .hot::before { background: #d55e00; } .scale { display: inline-flex; align-items: center; gap: 0.4rem; color: var(--ink); }
.scale .bar { display: inline-block; width: 9rem; height: 0.8rem; border-radius: 2px; } [hidden] { display: none !important; }
.viewer .symbol-name { margin-top: 0.45em; }
[data-mode] { cursor: pointer; } .u-legend { text-align: left !important; }
.u-select { background: var(--accent); opacity: 0.15; }
pre { overflow-x: auto; background: var(--panel); padding: 0.7rem 1rem; font-size: 0.8125rem; }
summary { cursor: pointer; margin: 0.3rem 0; }
footer { margin-top: 3rem; padding-top: 0.75rem; border-top: 1px solid var(--rule);
  color: var(--muted); font-size: 0.875rem; }
@media screen and (max-width: 46rem) {
  .pair, .answer { display: block; } .drawings { grid-template-columns: 1fr; } .modes { grid-template-columns: repeat(2, 1fr); } }
@media print {
  figure.is-live > svg, .is-live > .part, .is-live > .still { display: block; } .live, .controls { display: none; }
  @page { margin: 16mm 14mm; }
  main { max-width: none; padding: 0; } body { font-size: 9.5pt; }
  .first { display: block; }
  h2, h3 { break-after: avoid; } h2 { margin-top: 1.6rem; } table { font-size: 8.5pt; }
  th, td { padding-right: 0.5rem; } .note { break-after: avoid; } .n { padding-left: 0; }
  figure, tr, .scroll, .verdict, .warnings { break-inside: avoid; } .scroll { overflow: visible; }
  svg, .verdict, .warnings, .nominal { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
)css";

} // namespace plica
