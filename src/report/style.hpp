// SPDX-License-Identifier: Apache-2.0
// This header holds the style sheet of reports and studies, for screen and print.
#pragma once

namespace kerf::html {

inline constexpr const char* style = R"css(
:root { --ink: #22272e; --soft: #5b6470; --line: #dfe3e8; --wash: #f5f6f8;
        --yes: #1a6b3c; --no: #9a3412; --none: #3d4a5c; --paper: #fff; --link: #0b57a4; }
@media screen and (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --ink: #e6e9ed; --soft: #aab3be; --line: #3a424c; --wash: #22272e;
          --yes: #6fcf97; --no: #f2a17d; --none: #9fb0c6; --paper: #16191d; --link: #8ab8f0; }
  figure svg, figure img { background: #fff; border-radius: 3px; }
}
a { color: var(--link); }
* { box-sizing: border-box; }
html { font-size: 16px; }
body { margin: 0; color: var(--ink); background: var(--paper); line-height: 1.5;
       font-family: system-ui, "Segoe UI", "Helvetica Neue", "Noto Sans", "DejaVu Sans", Arial, sans-serif;
       font-variant-numeric: tabular-nums; }
main { max-width: 72rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; font-weight: 650; margin: 0 0 .35rem; letter-spacing: -.01em; }
h2 { font-size: 1.2rem; font-weight: 650; margin: 3rem 0 1rem; padding-top: .9rem;
     border-top: 1px solid var(--line); }
.meta { color: var(--soft); margin: 0 0 1.6rem; font-size: .95rem; }
.verdict { border-left: .4rem solid var(--none); background: var(--wash); margin: 0;
           padding: 1rem 1.25rem; font-size: 1.3rem; line-height: 1.35; font-weight: 600; }
.verdict.yes { border-color: var(--yes); } .verdict.no { border-color: var(--no); }
.verdict b { font-weight: 700; margin-right: .5rem; }
.verdict.yes b { color: var(--yes); } .verdict.no b { color: var(--no); }
.first { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 1.5rem 2rem;
         align-items: start; margin-top: 1.4rem; }
.first h2 { margin: 0 0 .4rem; padding: 0; border: 0; font-size: 1rem; }
.first .feed { margin: 0 0 1.2rem; font-size: 1.1rem; }
.first figure.kerf { margin: 0; }
.first figcaption { font-size: .85rem; color: var(--soft); }
.compared { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1.5rem 2rem; }
.compared h2 { border: 0; margin: 1rem 0 .3rem; padding: 0; } .compared .verdict { margin-bottom: 1rem; }
.compared pre { overflow-x: auto; font-size: .85rem; } .compared .meta { overflow-wrap: anywhere; }
ul.bodies { list-style: none; margin: 0; padding: 0; font-size: 1.1rem; }
ul.bodies li { display: flex; padding: .3rem 0; border-bottom: 1px solid var(--line); }
ul.bodies b { flex: none; width: 1.5rem; color: var(--none); }
ul.bodies .yes b { color: var(--yes); } ul.bodies .no b { color: var(--no); }
.figures { display: flex; flex-wrap: wrap; gap: 1px; background: var(--line);
           border: 1px solid var(--line); margin: 1.4rem 0 0; }
.figures div { background: var(--paper); padding: .8rem 1rem; flex: 1 1 14rem; }
.figures dt { color: var(--soft); font-size: .85rem; }
.figures dd { margin: .1rem 0 0; font-size: 1.25rem; font-weight: 600; }
.figures .note { font-size: .8rem; font-weight: 400; color: var(--soft); line-height: 1.35; }
p.remark { color: var(--soft); margin: 0 0 1rem; }
ul.validity { margin: .6rem 0 0; padding-left: 0; list-style: none; }
ul.validity b { flex: none; width: 1.2rem; color: var(--none); }
ul.validity .good b { color: var(--yes); } ul.validity .warning b { color: var(--no); }
ul.validity li { margin: .25rem 0; max-width: 62rem; display: flex; }
h3 { font-size: 1rem; margin: 1.8rem 0 0; font-weight: 650; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1.5rem; }
.pictures.wide { grid-template-columns: 1fr; }
figure { margin: 0; break-inside: avoid; }
figure img { width: 100%; height: auto; display: block; border: 1px solid var(--line); }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(28rem, 100%), 1fr)); gap: 2rem 1.75rem; }
.plots figcaption { font-weight: 600; margin-bottom: .2rem; }
.legend { font-weight: 400; font-size: .85rem; color: var(--soft); display: flex;
                 flex-wrap: wrap; gap: .1rem 1rem; min-height: 1.3rem; }
.legend span { white-space: nowrap; }
.swatch { display: inline-block; width: 1.4rem; margin-right: .4rem; vertical-align: middle; }
sub, sup { line-height: 0; }
svg { width: 100%; height: auto; display: block; }
figure.kerf { max-width: 42rem; margin-bottom: 1.5rem; }
svg text, svg tspan { font-family: inherit; }
.tables { columns: 2 30rem; column-gap: 2.5rem; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; margin: 0 0 2rem; break-inside: avoid; }
caption { text-align: left; font-weight: 650; padding-bottom: .4rem; }
th, td { text-align: left; font-weight: 400; padding: .28rem .5rem .28rem 0; vertical-align: baseline;
         border-bottom: 1px solid var(--line); }
#kerf-numbers thead th + th { text-align: right; }
td { text-align: right; white-space: nowrap; } td.remark { text-align: left; white-space: normal;
     color: var(--soft); padding-left: .75rem; }
summary { cursor: pointer; }
details.balance { margin: 0 0 2rem; } details.balance .tables { margin-top: 1rem; }
details.case pre { margin: .8rem 0 0; padding: .8rem 1rem; background: var(--wash); max-height: 32rem;
                   overflow: auto; font-family: ui-monospace, "DejaVu Sans Mono", monospace;
                   font-size: .8rem; line-height: 1.4; }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .9em; }
footer { color: var(--soft); font-size: .88rem; margin-top: 3rem; border-top: 1px solid var(--line);
         padding-top: 1rem; }
@media (max-width: 40rem) {
  main { padding: 1.2rem .9rem 2.5rem; }
  .first { grid-template-columns: minmax(0, 1fr); }
  .tables { columns: auto; }
  table { display: block; overflow-x: auto; }
  td { white-space: normal; }
}
@media print {
  @page { size: A4; margin: 14mm; }
  html { font-size: 10.5px; } main { padding: 0; max-width: none; }
  .pictures, .plots { grid-template-columns: 1fr 1fr; } .pictures.wide { grid-template-columns: 1fr; }
  .verdict, .figures div, .swatch { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  h2 { break-after: avoid; }
  details.case pre { max-height: none; overflow: visible; white-space: pre-wrap; overflow-wrap: anywhere; }
}
)css";

}  // namespace kerf::html
