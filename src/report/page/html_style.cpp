#include "report/page/html_style.h"

namespace stepmill {

const char* const kReportStyle = R"css(
:root { --ink:#1d2733; --soft:#5d6b7a; --line:#d5dce3; --paper:#fff; --accent:#0b6e99; --bad:#b3261e; }
* { box-sizing:border-box; }
body { font:14px/1.45 "DejaVu Sans",Helvetica,Arial,sans-serif; color:var(--ink); background:#eef1f4; margin:0; }
main { max-width:1080px; margin:0 auto; background:var(--paper); padding:28px 36px 48px; }
h1 { font-size:26px; margin:0 0 2px; } h2 { font-size:18px; margin:34px 0 10px; border-bottom:2px solid var(--ink); }
h3 { font-size:15px; margin:24px 0 6px; } p { margin:4px 0 10px; } .soft { color:var(--soft); }
.cards { display:flex; flex-wrap:wrap; gap:10px; margin:18px 0; }
.card { flex:1 1 130px; border:1px solid var(--line); border-radius:6px; padding:9px 12px; }
.card b { display:block; font-size:20px; } .card span { color:var(--soft); font-size:12px; }
table { border-collapse:collapse; width:100%; font-size:12.5px; margin:6px 0 12px; }
th { text-align:left; border-bottom:1.5px solid var(--ink); padding:3px 8px 3px 0; vertical-align:bottom; }
td { border-bottom:1px solid var(--line); padding:3px 8px 3px 0; vertical-align:top; }
td.n, th.n { text-align:right; font-variant-numeric:tabular-nums; white-space:nowrap; }
tr.chosen td { background:#e6f3f8; font-weight:600; }
.views, .steps { display:grid; grid-template-columns:repeat(2,1fr); gap:14px; }
figure { margin:0; border:1px solid var(--line); border-radius:6px; padding:8px; break-inside:avoid; }
figcaption { font-size:12px; color:var(--soft); padding-top:5px; }
svg { width:100%; height:290px; display:block; } .wide svg { height:380px; }
svg path, svg circle { vector-effect:non-scaling-stroke; fill:none; }
.visible { stroke:#1d2733; stroke-width:1.1; } .hidden { stroke:#9aa7b4; stroke-width:.6; stroke-dasharray:3 2.5; }
svg .obstruction { fill:#c3ccd5; stroke:#8f9ba7; stroke-width:.5; } svg .target { fill:#fdf6df; }
svg .fixture { fill:#e3d3e8; stroke:#8a6b95; stroke-width:.5; }
svg .swept { fill:#8ec9e3; fill-opacity:.55; } .wall { stroke:#1d2733; stroke-width:1.6; }
.open-edge { stroke:#2e8b57; stroke-width:1.6; stroke-dasharray:6 3; } .cut { stroke:#0b4f75; stroke-width:.8; }
svg .residual { fill:#d93025; stroke:#b3261e; stroke-width:.6; }
svg .tint { stroke:#1d2733; stroke-width:.9; fill-opacity:.75; }
svg .tint0{fill:#8ec9e3} svg .tint1{fill:#f4c97a} svg .tint2{fill:#a7d8a1} svg .tint3{fill:#e3a6a1}
svg .tint4{fill:#c3b1e1} svg .tint5{fill:#f2e394} svg .tint6{fill:#9adbd1} svg .tint7{fill:#e6b8d3}
.warn { border-left:4px solid #e0a100; background:#fff8e1; padding:5px 10px; margin:5px 0; font-size:13px; }
.bad { color:var(--bad); } details summary { cursor:pointer; color:var(--accent); font-size:12.5px; }
.key i { display:inline-block; width:16px; height:10px; margin:0 4px 0 12px; border:1px solid #8f9ba7; }
.key .key-stays { background:#c3ccd5; } .key .key-target { background:#fdf6df; } .key .key-swept { background:#8ec9e3; }
.key .key-residual { background:#d93025; } .key .key-path { background:#0b4f75; height:2px; }
.key .key-open { border:0; border-top:2px dashed #2e8b57; height:0; }
@media print { body { background:#fff; font-size:11px; } main { max-width:none; padding:0; } h2 { break-after:avoid; }
  section { break-inside:auto; } svg { height:225px; } details { display:none; } @page { size:A4; margin:14mm; } }
)css";

}  // namespace stepmill
