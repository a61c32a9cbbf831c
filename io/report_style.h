// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace stratareeb {

//! The report's looks: on screens light and dark, and on paper.
constexpr std::string_view kReportStyle = R"css(
:root { --ink: #1d2126; --soft: #5a626c; --line: #d9dde2; --paper: #ffffff; --panel: #f5f6f8; --good: #1a7f4b; --bad: #b3261e; --link: #0b57a4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8eb; --soft: #a3abb5; --line: #3a4149; --paper: #16191d; --panel: #1f2429; --good: #5fc992; --bad: #ff8a80; --link: #8ab8ee; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 1180px; margin: 0 auto; padding: 24px 20px 60px; }
h1 { font-size: 28px; margin: 8px 0 16px; }
h2 { font-size: 19px; margin: 40px 0 10px; padding-bottom: 4px; border-bottom: 1px solid var(--line); }
a { color: var(--link); }
.facts { display: flex; flex-wrap: wrap; gap: 12px; margin: 0 0 16px; }
.facts div { background: var(--panel); border-radius: 6px; padding: 10px 16px; }
.facts b { display: block; font-size: 20px; font-variant-numeric: tabular-nums; }
.facts span, figcaption, .note { color: var(--soft); font-size: 13px; }
figure { margin: 0 0 18px; break-inside: avoid; }
figure img { width: 100%; height: auto; background: #ffffff; border: 1px solid var(--line); border-radius: 4px; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 540px), 1fr)); gap: 18px; align-items: start; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; color: var(--soft); vertical-align: bottom; }
th, td { padding: 5px 14px 5px 0; border-bottom: 1px solid var(--line); }
.number { text-align: right; white-space: nowrap; }
.stack { display: block; }
td:first-child { white-space: nowrap; }
td i { display: inline-block; width: 14px; height: 14px; border-radius: 3px; margin-right: 8px; vertical-align: -2px; }
tr.sum td { font-weight: 600; }
img.small { width: 200px; height: auto; display: block; background: #ffffff; border-radius: 3px; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
code { background: var(--panel); padding: 1px 5px; border-radius: 3px; font-size: 12.5px; }
summary { cursor: pointer; }
.stack figure { max-width: 980px; }
@media print { :root { --ink: #000; --soft: #444; --line: #bbb; --paper: #fff; --panel: #fff; } main { max-width: none; padding: 0; }
  @page { margin: 14mm; }
  h2 { break-after: avoid; } tr { break-inside: avoid; } .figures { grid-template-columns: 1fr 1fr; } body { font-size: 11px; }
  .wide { overflow: visible; } table { font-size: 8.5px; max-width: 100%; } th, td { padding: 3px 6px 3px 0; overflow-wrap: anywhere; }
  img.small { width: 90px; } td i { width: 9px; height: 9px; margin-right: 4px; } }
)css";

}  // namespace stratareeb
