// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/style.h"

namespace cbvh::testbench {

const char* const kReportStyle = R"(
:root {
  --paper: #ffffff; --panel: #f6f7f9; --ink: #1a2230; --soft: #566175; --rule: #d9dee6; --grid: #e6e9ef; --accent: #0b57b7;
  --good: #12693f; --good-panel: #e7f5ec; --bad: #a3171b; --bad-panel: #fdeaea; --none: #6b5310; --none-panel: #fbf4df;
  --s0: #0b62c4; --s1: #c2410c; --s2: #0f7b5f; --s3: #8b3fc9; --s4: #8f6400; --s5: #be185d; --s6: #475569; --s7: #0e7490;
  --f0: #4b86cc; --f1: #f0b27a; --f2: #8fd0b5; --f3: #c9b3e6; --f4: #e3d28f; --hatch: #1a2230;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #12161d; --panel: #1a2029; --ink: #e7ebf2; --soft: #a3aebf; --rule: #323b49; --grid: #262e3a; --accent: #7db6ff;
    --good: #6fdba2; --good-panel: #14301f; --bad: #ff9a97; --bad-panel: #3a1719; --none: #ecca6e; --none-panel: #332a10;
    --s0: #6cb0ff; --s1: #ff9a62; --s2: #4fd1a5; --s3: #c79bff; --s4: #f2c14e; --s5: #ff8fbf; --s6: #a9b6c8; --s7: #5fd3ea;
    --f0: #4d8ad6; --f1: #c4672a; --f2: #2f8f6c; --f3: #7e5bb0; --f4: #927a1f; --hatch: #f2f5fa;
  }
}
* { box-sizing: border-box; }
html { background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, "Segoe UI", "DejaVu Sans", Arial, sans-serif; }
body { max-width: 70rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .25rem; letter-spacing: -.01em; }
h2 { font-size: 1.4rem; margin: 3rem 0 1rem; padding-bottom: .35rem; border-bottom: 2px solid var(--rule); }
h3 { font-size: 1.05rem; margin: 2rem 0 .6rem; overflow-wrap: anywhere; }
h4 { font-size: .95rem; margin: 1.4rem 0 .4rem; }
a { color: var(--accent); }
.lead { color: var(--soft); margin: 0 0 1.25rem; }
.banner { display: flex; flex-wrap: wrap; align-items: center; gap: .75rem 2.5rem; padding: 1rem 1.25rem; border-radius: .6rem; border-left: .4rem solid; }
.banner .verdict { font-size: 1.25rem; font-weight: 650; margin: 0; }
.banner dl { display: flex; flex-wrap: wrap; gap: .25rem 2rem; margin: 0; color: var(--ink); }
.banner dl div { display: flex; gap: .5rem; align-items: baseline; }
.banner dt { color: var(--soft); } .banner dd { margin: 0; font-weight: 650; font-variant-numeric: tabular-nums; }
.banner.passed { background: var(--good-panel); } .banner.failed { background: var(--bad-panel); } .banner.none { background: var(--none-panel); }
.passed { color: var(--good); } .failed { color: var(--bad); } .none { color: var(--none); }
td.failed { font-weight: 650; }
nav ul { list-style: none; display: flex; flex-wrap: wrap; gap: .35rem 1.25rem; padding: 0; margin: 1.25rem 0 0; }
article + article { margin-top: 2.5rem; padding-top: 1.5rem; border-top: 1px solid var(--rule); }
.source { margin: 0; display: flex; flex-wrap: wrap; gap: .3rem .8rem; align-items: baseline; font-size: .85rem; }
.source .file { font-weight: 650; }
code { font: .85em/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; color: var(--soft); overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; margin: .25rem 0; }
caption { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
th, td { padding: .3rem .55rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); font-weight: normal; }
thead th { font-weight: 650; color: var(--soft); vertical-align: bottom; border-bottom: 2px solid var(--rule); }
th.number, td.number { text-align: right; white-space: nowrap; }
tbody th { position: sticky; left: 0; background: var(--paper); } figure tbody th { background: var(--panel); }
tbody tr:hover th, tbody tr:hover { background: var(--panel); }
.paper, tr.paper th, tr.paper td { color: var(--soft); font-style: italic; }
td.passed, td.failed, td.none { white-space: nowrap; } td.prose { min-width: 18rem; } .matrix { margin-bottom: 1.5rem; }
table.files code { color: var(--ink); }
.notes { margin: .5rem 0; padding-left: 1.2rem; color: var(--soft); font-size: .85rem; }
.failures { color: var(--bad); font-weight: 650; }
figure { margin: 1.5rem 0; padding: 1rem 1.1rem .7rem; background: var(--panel); border: 1px solid var(--rule); border-radius: .6rem; break-inside: avoid; }
figcaption { font-weight: 650; font-size: .95rem; overflow-wrap: anywhere; }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.3rem; padding: 0; margin: .35rem 0 .2rem; font-size: .82rem; color: var(--ink); }
.legend li { display: flex; align-items: center; gap: .45rem; }
.sample { width: 34px; height: 14px; flex: none; }
figure > .scroll > svg { display: block; width: 100%; height: auto; margin-top: .4rem; }
figure.wide > .scroll > svg { min-width: 34rem; }
.multiples { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1rem; }
.multiples figure { margin: 0; padding: .8rem .8rem .5rem; }
details { font-size: .85rem; margin-top: .3rem; }
summary { cursor: pointer; color: var(--soft); }
svg text { fill: var(--soft); font-size: 12px; font-family: inherit; }
svg .label { fill: var(--ink); } svg .value { fill: var(--ink); font-variant-numeric: tabular-nums; }
svg .group { fill: var(--ink); font-weight: 650; font-size: 12.5px; stroke: var(--panel); stroke-width: 4px; paint-order: stroke; }
svg .value { stroke: var(--panel); stroke-width: 3px; paint-order: stroke; }
.grid { stroke: var(--grid); stroke-width: 1; } .axis { stroke: var(--soft); stroke-width: 1; }
.hatch { stroke: var(--hatch); stroke-width: 1; stroke-opacity: .55; fill: none; }
.reference { fill: var(--ink); stroke: var(--panel); stroke-width: 1.2; }
.line { fill: none; stroke-width: 2; stroke-linejoin: round; }
.mark { stroke-width: 1; stroke: var(--panel); }
.s0.line { stroke: var(--s0); } .s0.mark { fill: var(--s0); }
.s1.line { stroke: var(--s1); stroke-dasharray: 8 4; } .s1.mark { fill: var(--s1); }
.s2.line { stroke: var(--s2); stroke-dasharray: 2 3; } .s2.mark { fill: var(--s2); }
.s3.line { stroke: var(--s3); stroke-dasharray: 9 3 2 3; } .s3.mark { fill: var(--s3); }
.s4.line { stroke: var(--s4); stroke-dasharray: 14 4; } .s4.mark { fill: var(--s4); }
.s5.line { stroke: var(--s5); stroke-dasharray: 5 2 1 2 1 2; } .s5.mark { fill: var(--s5); }
.s6.line { stroke: var(--s6); stroke-dasharray: 4 4; } .s6.mark { fill: var(--s6); }
.s7.line { stroke: var(--s7); stroke-dasharray: 1 4; } .s7.mark { fill: var(--s7); }
.f0 { fill: var(--f0); } .f1 { fill: var(--f1); } .f2 { fill: var(--f2); } .f3 { fill: var(--f3); } .f4 { fill: var(--f4); }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(24rem, 100%), 1fr)); gap: 1.25rem; }
.picture { margin: 0; } .picture img { display: block; width: 100%; height: auto; border-radius: .3rem; margin-bottom: .5rem; }
.picture figcaption { font-weight: normal; font-size: .85rem; color: var(--soft); } .picture strong { color: var(--ink); }
@media print {
  html { font-size: 10.5pt; } body { max-width: none; padding: 0; } nav { display: none; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  table { font-size: 7pt; } th, td { padding: 2pt 3pt; } th.number { white-space: normal; } td.prose { min-width: 0; }
  h2, h3, h4 { break-after: avoid; } tr { break-inside: avoid; } .scroll { overflow: visible; }
  details.long::details-content { content-visibility: visible; display: block; }
  figure.wide > .scroll > svg { min-width: 0; }
}
)";

}  // namespace cbvh::testbench
