// The report's look. Charts take their ink from here too, so that dark screens and white paper need no redrawing.
#include "suffuse/report/page.hpp"

namespace suffuse::report {

std::string_view page_style() {
    return R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --panel: #f7f6f3; --ink: #1d1f21; --soft: #55595e; --line: #d9d6cf; --grid: #e6e4de;
  --accent: #1f5f8b; --water: #1668a8; --met: #14653f; --met-back: #e1f3e8; --not: #96281b; --not-back: #fbe5e1;
  --open: #6b5300; --open-back: #f8efd0; --warn-back: #fdf3d9; --warn-line: #c99a2e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16181b; --panel: #1f2226; --ink: #e8e6e1; --soft: #a9adb3; --line: #3a3e44; --grid: #2d3136;
    --accent: #82bde6; --water: #7cc0f5; --met: #8fdcae; --met-back: #143524; --not: #f5a195; --not-back: #431c17;
    --open: #e8cf80; --open-back: #3a3010; --warn-back: #33290f; --warn-line: #a67f22;
  }
}
* { box-sizing: border-box; }
html { scroll-behavior: smooth; scroll-padding-top: 1rem; }
@media (prefers-reduced-motion: reduce) { html { scroll-behavior: auto; } }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, Helvetica, Arial, "DejaVu Sans", sans-serif;
}
header, main { max-width: 78rem; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 2.2rem; }
h1 { font-size: clamp(1.5rem, 1rem + 2vw, 2.2rem); line-height: 1.2; margin: .2rem 0 1rem; text-wrap: balance; overflow-wrap: anywhere; }
h2 { font-size: 1.4rem; margin: 2.8rem 0 .8rem; padding-bottom: .3rem; border-bottom: 2px solid var(--ink); }
h3 { font-size: 1.08rem; margin: 1.6rem 0 .5rem; }
p { margin: .5rem 0; }
a { color: var(--accent); }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; border-radius: 2px; }
.quiet { color: var(--soft); margin: 0; font-size: .9rem; overflow-wrap: anywhere; }
.skip { position: absolute; left: -999rem; }
.skip:focus { left: 1rem; top: .5rem; background: var(--paper); padding: .3rem .6rem; z-index: 2; }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; padding: .6rem 0; border-top: 1px solid var(--line); border-bottom: 1px solid var(--line); }
nav a { text-decoration: none; font-weight: 600; }
nav a:hover { text-decoration: underline; }
.answer { font-size: 1.12rem; max-width: 46rem; }
.opening { display: grid; grid-template-columns: minmax(0, 46rem); gap: 1.2rem 3rem; }
.headlines { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .8rem; margin: 0; align-content: start; }
.headlines > div { background: var(--panel); border-top: 3px solid var(--accent); padding: .6rem .9rem .7rem; display: flex; flex-direction: column; }
.headlines dt { color: var(--soft); font-size: .86rem; }
.headlines dd { margin: 0; }
.headlines .value { font-size: 1.65rem; font-weight: 700; line-height: 1.25; font-variant-numeric: tabular-nums; }
.headlines .quiet { font-size: .82rem; }
@media (min-width: 70rem) {
  .opening { grid-template-columns: minmax(0, 44rem) minmax(20rem, 1fr); }
  .headlines { grid-template-columns: 1fr 1fr; }
}
.warnings, .missing { background: var(--warn-back); border-left: 4px solid var(--warn-line); padding: .6rem 1rem; margin: 1.2rem 0; }
.late { animation: appear .1s 3s both; overflow: hidden; }
@keyframes appear { from { max-height: 0; padding: 0 1rem; margin: 0; visibility: hidden; } to { max-height: 20rem; } }
.warnings h3 { margin: 0 0 .2rem; }
ul.plain { margin: 0; padding-left: 1.1rem; }
.scroll { overflow-x: auto; max-width: 100%; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .42rem .7rem; border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-weight: 600; border-bottom: 2px solid var(--line); vertical-align: bottom; }
.number { text-align: right; }
td.number { white-space: nowrap; }
table.numbers { width: auto; min-width: 50%; font-size: .84rem; }
table.numbers th, table.numbers td { padding: .2rem .7rem; }
table.page-table td:first-child { min-width: 9rem; }
@media screen { table.page-table td.long:not(:first-child) { min-width: 17rem; } }
table.provenance { overflow-wrap: anywhere; }
table.provenance td:first-child, table.stages td:first-child { font-weight: 600; }
table.provenance td:first-child { width: 14rem; }
table.findings td:nth-child(2) { min-width: 13rem; }
table.findings td:nth-child(3), table.findings td:nth-child(4) { min-width: 11rem; }
@media screen and (max-width: 48rem) {
  table.findings, table.findings tbody { display: block; }
  table.findings thead { display: none; }
  table.findings tr { display: grid; grid-template-columns: 2.6rem minmax(0, 1fr); padding: .6rem 0; border-bottom: 1px solid var(--line); }
  table.findings th, table.findings td { border: 0; padding: .15rem .3rem; grid-column: 2; }
  table.findings th { grid-column: 1; }
  table.findings td[data-label]::before { content: attr(data-label) ": "; color: var(--soft); }
  table.findings td:nth-child(2) { font-weight: 600; }
  .verdict { width: fit-content; }
}
.verdict { white-space: nowrap; font-weight: 600; }
.met { color: var(--met); background: var(--met-back); }
.not-met { color: var(--not); background: var(--not-back); }
.unknown { color: var(--open); background: var(--open-back); }
details { margin: .6rem 0; }
summary { cursor: pointer; color: var(--accent); font-size: .92rem; width: fit-content; }
sub { font-size: .75em; line-height: 0; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Consolas, monospace; font-size: .86em; }
pre { white-space: pre-wrap; background: var(--panel); padding: 1rem; overflow-wrap: anywhere; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.4rem 3rem; margin-top: 1.4rem; }
.figure { margin: 0 0 1rem; padding: 0; min-width: 0; }
.figure.wide { grid-column: 1 / -1; }
@media (min-width: 64rem) {
  .drawn, .figure:only-child:not(.wide) { display: grid; grid-template-columns: minmax(0, max-content) minmax(18rem, 1fr); gap: 0 3rem; }
  .drawn h3, .figure:only-child:not(.wide) h3 { grid-column: 1 / -1; }
  .figure:only-child:not(.wide) .chart { width: 41rem; }
}
.figure h3 { margin-top: .4rem; }
.figure figcaption { max-width: 46rem; color: var(--ink); font-size: .95rem; margin-top: .5rem; }
.chart, .drawing { min-height: 2rem; max-width: 100%; }
.chart svg, .drawing svg { max-width: 100%; height: auto; display: block; }
.tools { display: flex; flex-wrap: wrap; align-items: center; gap: .6rem; margin-top: .5rem; font-size: .9rem; }
.buttons { display: contents; }
button {
  font: inherit; color: var(--accent); background: none; border: 1px solid var(--line); border-radius: 5px;
  padding: .12rem .7rem; cursor: pointer;
}
button:hover { border-color: var(--accent); }
/* Ink of charts and drawings */
.chart .role-axis-label text, .chart .role-axis-title text, .chart .role-legend-label text, .chart .role-legend-title text,
.chart .role-title-text text, .drawing text { fill: var(--ink); }
.chart .role-axis-grid line { stroke: var(--grid); }
.chart .role-axis-domain line, .chart .role-axis-tick line { stroke: var(--soft); }
.chart .role-mark.mark-text text { fill: var(--ink); }
.drawing .flow-box { fill: var(--panel); stroke: var(--soft); }
.drawing .flow-arrow { stroke: var(--soft); }
.drawing .flow-head { fill: var(--soft); }
.drawing .flow-label, .drawing .flow-what { fill: var(--soft); }
/* Grains in 3D */
.view3d { display: grid; grid-template-columns: minmax(0, 1fr); gap: 1rem 1.5rem; margin: .8rem 0 1.2rem; }
.view3d[hidden] { display: none; }
.stage { position: relative; min-width: 0; }
.picture { position: relative; height: clamp(22rem, 58vw, 44rem); background: var(--panel); color: var(--soft); border: 1px solid var(--line); border-radius: 6px; overflow: hidden; touch-action: pan-y; }
.picture canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; cursor: grab; touch-action: none; }
.picture canvas:active { cursor: grabbing; }
.overlay { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }
.overlay text { font-size: 13px; fill: var(--ink); }
.overlay line, .overlay path { stroke: var(--ink); stroke-width: 1.5; fill: none; }
.overlay polygon { fill: var(--ink); }
.overlay line.water { stroke: var(--water); stroke-width: 3; }
.overlay polygon.water, .overlay text.water { fill: var(--water); }
.overlay circle { fill: none; }
.overlay .halo { stroke: var(--paper); stroke-width: 5; }
.overlay .ring { stroke: var(--ink); stroke-width: 2; }
.panel { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr)); gap: .2rem 1.2rem; align-content: start; font-size: .92rem; }
@media (min-width: 58rem) {
  .view3d { grid-template-columns: minmax(0, 1fr) 17rem; }
  .panel { grid-template-columns: minmax(0, 1fr); }
}
.panel fieldset { border: 0; border-top: 1px solid var(--line); margin: 0; padding: .3rem 0 .5rem; min-width: 0; }
.panel legend { font-weight: 600; padding: 0 .5rem 0 0; }
.control { display: grid; grid-template-columns: 6.2rem minmax(0, 1fr); align-items: center; gap: 0 .5rem; margin: .15rem 0; }
.control[hidden], .check[hidden] { display: none; }
.control label { color: var(--soft); }
.control output { grid-column: 2; font-size: .86rem; }
.control select, .control input { font: inherit; min-width: 0; width: 100%; color: inherit; accent-color: var(--accent); }
.control select, .control input[type=number] { background: var(--paper); border: 1px solid var(--line); border-radius: 4px; padding: .1rem .3rem; }
.checks { display: flex; flex-wrap: wrap; gap: .1rem 1rem; margin-bottom: .2rem; }
.check { white-space: nowrap; }
.check input { accent-color: var(--accent); }
.legend { margin-top: .4rem; font-size: .88rem; }
.swatch { display: flex; align-items: center; gap: .5rem; }
.swatch i { width: .85rem; height: .85rem; border-radius: 50%; flex: none; border: 1px solid var(--soft); }
.scale-bar { height: .7rem; border-radius: 3px; }
.scale-ends { display: flex; justify-content: space-between; font-variant-numeric: tabular-nums; }
.card { background: var(--panel); border-left: 3px solid var(--accent); padding: .4rem .8rem .5rem; margin-top: .4rem; }
.card h3 { margin: 0 0 .2rem; font-size: 1rem; }
.card dl { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1.1fr); gap: .05rem .6rem; margin: 0; font-size: .86rem; }
.card dt { color: var(--soft); }
.card dd { margin: 0; font-variant-numeric: tabular-nums; }
.card .neighbors { font-size: .86rem; margin: .3rem 0 0; line-height: 1.9; }
.card button { padding: 0 .4rem; font-size: .86rem; }
.keys { margin-top: .4rem; }
.stills { display: flex; flex-wrap: wrap; gap: 1rem 2.5rem; margin: .8rem 0; }
.still { margin: 0; max-width: 28rem; }
.still img { display: block; width: 100%; height: auto; }
@media screen { .has-view .stills { display: none; } }
#vg-tooltip-element {
  position: fixed; visibility: hidden; z-index: 10; pointer-events: none; padding: .35rem .6rem; font-size: .82rem;
  background: var(--paper); color: var(--ink); border: 1px solid var(--soft); border-radius: 4px; box-shadow: 0 2px 8px #0003;
}
#vg-tooltip-element.visible { visibility: visible; }
#vg-tooltip-element table { width: auto; font-size: inherit; }
#vg-tooltip-element td { border: 0; padding: .05rem .4rem .05rem 0; }
#vg-tooltip-element td.key { color: var(--soft); text-align: right; }
@media print {
  :root {
    --paper: #ffffff; --panel: #f7f6f3; --ink: #000000; --soft: #444444; --line: #bbbbbb; --grid: #e2e2e2; --accent: #000000; --water: #1668a8;
    --met: #14653f; --met-back: #ffffff; --not: #96281b; --not-back: #ffffff; --open: #6b5300; --open-back: #ffffff;
    --warn-back: #ffffff; color-scheme: light;
  }
  @page { margin: 16mm 15mm; }
  body { font-size: 10.5pt; }
  header, main { max-width: none; padding: 0; }
  nav, .tools, .skip, .view3d, [data-no-view], details:not([open]) { display: none; }
  .chart svg, .drawing svg { max-height: 90mm; width: auto; }
  .stills { flex-wrap: nowrap; }
  .figure, .still, table.findings tr { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .scroll { overflow: visible; }
  .headlines { grid-template-columns: repeat(4, 1fr); }
  .opening { grid-template-columns: 1fr; }
  table { font-size: 8.5pt; }
  th, td { padding: .25rem .35rem; }
}
)css";
}

} // namespace suffuse::report
