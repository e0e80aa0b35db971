//! How a page is laid out: on screens wide and narrow, and on paper.

/// Rules for everything but pictures.
pub const LAYOUT: &str = "\
*{box-sizing:border-box}\
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 Inter,'Segoe UI',Helvetica,Arial,sans-serif}\
main{max-width:1020px;margin:0 auto;padding:32px 28px 48px}\
h1{font-size:27px;line-height:1.2;margin:0 0 6px;letter-spacing:-.01em}\
h2{font-size:19px;line-height:1.3;margin:44px 0 12px;padding-bottom:6px;border-bottom:1px solid var(--grid)}\
h3{font-size:13px;text-transform:uppercase;letter-spacing:.06em;color:var(--soft);margin:22px 0 8px}\
h3 code{text-transform:none;letter-spacing:0}\
h4{font-size:13.5px;margin:6px 0 0}\
p{margin:8px 0;max-width:78ch}\
code{font:.92em 'JetBrains Mono','SF Mono',Consolas,'DejaVu Sans Mono',monospace}\
header p{margin:4px 0;color:var(--soft)}\
a{color:var(--curve0)}\
nav ol{padding-left:22px;columns:2 300px;column-gap:40px}nav li{break-inside:avoid;margin:3px 0}\
.chip{font-size:12px;font-weight:600;white-space:nowrap}\
.chip.holds{color:var(--holds)}.chip.partly{color:var(--partly)}.chip.fails{color:var(--fails)}.chip.open{color:var(--soft)}\
.finding{border-left:4px solid var(--soft);padding:8px 16px;margin:14px 0;background:color-mix(in srgb,var(--grid) 34%,transparent);border-radius:0 6px 6px 0}\
.finding.holds{border-color:var(--holds)}.finding.partly{border-color:var(--partly)}.finding.fails{border-color:var(--fails)}\
.finding p{margin:3px 0;max-width:none}.finding .claim{font-weight:600}.finding .chip{margin-right:8px}\
figure{margin:14px 0 4px}figure svg{width:100%;height:auto;display:block}\
figcaption,.remark{color:var(--soft);font-size:13px;margin:4px 0 0;max-width:88ch}\
.narrow-only{display:none!important}\
.grid-of-charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(340px,100%),1fr));gap:12px 24px}\
details.behind{margin:2px 0 18px}summary{cursor:pointer;color:var(--soft);font-size:13px}\
details details{margin:6px 0}\
.controls{display:flex;gap:14px;align-items:center;margin:4px 0}.controls[hidden]{display:none}.controls input{flex:1 1 200px;max-width:420px;accent-color:var(--curve0)}.controls button{min-width:72px}.controls output{font-size:13px;color:var(--soft);font-variant-numeric:tabular-nums;min-width:80px}\
.mechanism{display:flex;flex-wrap:wrap;gap:20px 34px;align-items:center}\
.mechanism figure{flex:1 1 540px;min-width:0}.mechanism .facts{flex:1 1 300px;width:auto}.facts th{white-space:normal}\
table{border-collapse:collapse;width:100%;font-size:13.5px}\
th,td{text-align:left;padding:3.5px 14px 3.5px 0;border-bottom:1px solid var(--grid);vertical-align:baseline}\
tbody th{font-weight:600;white-space:nowrap}th.plain{font-weight:400;color:var(--soft)}\
thead th{font-weight:400;color:var(--soft);vertical-align:bottom}\
td{font-variant-numeric:tabular-nums}.value{white-space:nowrap}.meaning{color:var(--soft)}\
.numbers{width:auto}.numbers td,.numbers thead th{text-align:right;padding:3px 10px;white-space:nowrap}.numbers .words{text-align:left;white-space:normal}\
.numbers td:first-child,.numbers th:first-child{padding-left:0}.unit{font-size:12px}\
.scroll{overflow:auto;max-height:480px}\
.changed th{color:var(--curve3)}.changed .value{color:var(--curve3);font-weight:600}\
.columns{display:grid;grid-template-columns:3fr 2fr;gap:0 44px}.columns>div{min-width:0}\
pre{font:13px/1.55 'JetBrains Mono','SF Mono',Consolas,'DejaVu Sans Mono',monospace;overflow-x:auto;margin:8px 0;padding:14px 16px;background:color-mix(in srgb,var(--grid) 38%,transparent);border-radius:6px}\
pre.values{max-height:220px;font-size:12px}\
button{font:inherit;font-size:13px;color:var(--ink);background:var(--paper);border:1px solid var(--frame);border-radius:5px;padding:2px 12px;cursor:pointer}\
.notice{border-left:4px solid var(--contact);padding:8px 14px;margin:18px 0;max-width:none;background:color-mix(in srgb,var(--contact) 9%,transparent)}\
.equations{overflow-x:auto}.equations table{width:auto;font-size:15px;margin:6px 0}\
.equations td{border:0;padding:3px 0;vertical-align:middle;white-space:nowrap}\
.equations td.left{text-align:right;padding-right:.3em}.equations td.note{color:var(--soft);font-size:13px;padding-left:28px}\
.equations math{display:inline math}.equations p{margin:10px 0 4px}\
math{font-family:'STIX Two Math','Latin Modern Math','Cambria Math','Libertinus Math','Noto Sans Math',math;font-size:1.08em}\
footer{margin-top:40px;color:var(--soft);font-size:12.5px}\
@media screen and (max-width:640px){.wide-only{display:none!important}.narrow-only{display:block!important}\
main{padding:20px 16px 36px}.columns{grid-template-columns:1fr}h1{font-size:23px}.mechanism figure{flex-basis:100%}}\
@media print{@page{margin:16mm}body{font-size:10.5pt}main{padding:0;max-width:none}\
figure,tr,.finding,.columns>div{break-inside:avoid}h2,h3{break-after:avoid}\
button,details.behind,.controls,nav .remark{display:none}.scroll{overflow:visible;max-height:none}\
.equations{overflow:visible}.equations td{white-space:normal}a{color:inherit;text-decoration:none}\
*{-webkit-print-color-adjust:exact;print-color-adjust:exact}}";
