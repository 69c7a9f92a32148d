#include "hair/io/plot/html.h"

#include <stdexcept>

#include "hair/io/files/base64.h"
#include "hair/io/plot/readable.h"

namespace hair {

namespace {

// Colours: text on its background has a contrast of at least 4.5 in both schemes.
constexpr std::string_view style = R"css(
:root {
  color-scheme: light dark;
  --page: #ffffff; --soft: #f5f6f8; --line: #dfe2e7; --text: #1d2129; --quiet: #5b6472; --link: #1a56b0;
  --good: #1a6b36; --good-soft: #e4f3e8; --part: #855400; --part-soft: #fcf0d9;
  --bad: #a8201a; --bad-soft: #fbe7e5; --none: #545c69; --none-soft: #eceef1;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #15181d; --soft: #1d2128; --line: #333a45; --text: #e4e7eb; --quiet: #a0a9b6; --link: #8ab8ff;
    --good: #7fd39a; --good-soft: #17301f; --part: #efbf6a; --part-soft: #352a14;
    --bad: #ff9d94; --bad-soft: #3b1c1a; --none: #b2bac6; --none-soft: #272c34;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 60rem; background: var(--page); color: var(--text);
  font: 1rem/1.55 system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
h1 { margin: 0; font-size: 1.75rem; line-height: 1.2; overflow-wrap: anywhere; }
h2 { margin: 2.75rem 0 .25rem; font-size: 1.25rem; line-height: 1.3; }
h3 { margin: 1.25rem 0 .25rem; font-size: 1rem; }
li { overflow-wrap: anywhere; }
p { margin: .4rem 0; max-width: 44rem; }
a { color: var(--link); text-underline-offset: .15em; }
code, pre { font: .875rem/1.5 ui-monospace, "SFMono-Regular", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
pre { margin: .5rem 0; padding: .75rem 1rem; overflow-x: auto; background: var(--soft); border: 1px solid var(--line);
  border-radius: .375rem; white-space: pre-wrap; overflow-wrap: anywhere; }
table { width: 100%; margin: .75rem 0; border-collapse: collapse; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--quiet); padding-bottom: .25rem; }
th, td { padding: .45rem .75rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
thead th { color: var(--quiet); font-size: .875rem; font-weight: 600; border-bottom-width: 2px; }
tbody th { font-weight: 500; overflow-wrap: anywhere; min-width: 6.5rem; }
tfoot th, tfoot td { border-bottom: 0; color: var(--quiet); }
.number { text-align: right; white-space: nowrap; }
.quiet { color: var(--quiet); }
.total { margin: .5rem 0 0; font-size: 1.25rem; font-variant-numeric: tabular-nums; }
.total strong { font-size: 2rem; font-weight: 650; }
.line { display: flex; flex-wrap: wrap; gap: .25rem .75rem; align-items: baseline; margin: .25rem 0; }
.badge { display: inline-block; padding: .05rem .55rem; border-radius: 1rem; font-size: .8125rem; font-weight: 550;
  white-space: nowrap; }
.good { color: var(--good); background: var(--good-soft); } .part { color: var(--part); background: var(--part-soft); }
.bad { color: var(--bad); background: var(--bad-soft); } .none { color: var(--none); background: var(--none-soft); }
.note, .stamp { max-width: none; margin: 1.25rem 0; padding: .75rem 1rem; border-left: .25rem solid; border-radius: .25rem; }
.note { color: var(--part); background: var(--part-soft); white-space: pre-line; overflow-wrap: anywhere; }
.stamp { color: var(--bad); background: var(--bad-soft); font-weight: 600; }
.bars { display: flex; align-items: flex-end; gap: .25rem; height: 8rem; margin: .75rem 0 0; padding: 0; list-style: none; }
.bars li { flex: 1; display: flex; flex-direction: column; justify-content: flex-end; height: 100%; text-align: center;
  font-size: .75rem; color: var(--quiet); }
.bars .bar { background: var(--link); border-radius: .125rem .125rem 0 0; opacity: .75; }
.bars .range { padding-top: .25rem; border-top: 1px solid var(--line); }
.share { display: flex; height: .5rem; min-width: 8rem; overflow: hidden; border-radius: .25rem;
  background: var(--none-soft); margin-top: .45rem; }
.track { position: relative; height: 1.25rem; min-width: 9rem; border-radius: .25rem; background: linear-gradient(var(--line), var(--line)) center / 1px 100% no-repeat var(--none-soft); }
.track .noise { position: absolute; top: 0; bottom: 0; background: var(--quiet); opacity: .35; } .track .dot { position: absolute; top: .3rem; width: .65rem; height: .65rem; margin-left: -.325rem; border-radius: 1rem; background: var(--link); }
.ends { display: flex; justify-content: space-between; } .tenths { display: flex; align-items: flex-end; gap: 1px; height: 1.75rem; width: 8rem; } .tenths span { flex: 1; min-height: 1px; background: var(--link); opacity: .75; }
.share span { background: var(--link); opacity: .75; }
details { margin: .35rem 0; } summary { cursor: pointer; } details ul { margin: .4rem 0; padding-left: 1.25rem; }
.category { width: 27%; } .status { width: 9rem; } .saw { width: 40%; }
nav { margin-top: .75rem; font-size: .9375rem; } nav a { margin-right: 1rem; }
.wide { overflow-x: auto; } .wide table { min-width: 40rem; } body:has(.class) { max-width: none; }
.fold { display: block; margin: .5rem 0; } :is(main, section):has(> .fold input:not(:checked)) .more { display: none; }
.wide .overview { width: auto; min-width: 0; } .overview th, .overview td { padding: .3rem 1.5rem .3rem 0; }
.class th, .class td { padding: .35rem .25rem; } .who { columns: 12rem; } .class tbody td { white-space: nowrap; } .class tbody td.decided, :is(.decided, summary) .badge { white-space: normal; } .class tbody th { min-width: 8.5rem; }
.class a.badge { text-decoration: none; min-width: 2.75rem; padding: .1rem .35rem; font-size: .75rem; text-align: right; } .class a.badge:hover { text-decoration: underline; }
th button { all: unset; cursor: pointer; } th button:hover { text-decoration: underline; }
th button:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
th[aria-sort=ascending] button::after { content: " \2191"; } th[aria-sort=descending] button::after { content: " \2193"; }
.moment { margin: .75rem 0 1.25rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(17rem, 1fr)); gap: .5rem .75rem; }
.pictures.one { grid-template-columns: minmax(0, 30rem); }
figure { margin: 0; } figcaption { color: var(--quiet); font-size: .875rem; }
figure img { display: block; width: 100%; height: auto; border-radius: .25rem; background: #000; }
svg { display: block; margin: 1rem 0 1.5rem; max-width: 100%; height: auto; border-radius: .375rem; }
figure:has(> svg) { overflow-x: auto; } figure > svg { min-width: 36rem; }
nav ul { margin: .4rem 0; padding-left: 1.25rem; } .text { text-align: left; }
.scale { display: inline-block; width: 5rem; height: .6rem; margin: 0 .35rem; border-radius: .125rem; }
.film div { width: min(100%, 30rem); aspect-ratio: 104 / 27; background-size: 100% calc(100% * var(--moments)); image-rendering: pixelated; }
.film:has(:checked) div { animation: film 4s steps(var(--moments), jump-none) infinite; } @keyframes film { to { background-position: 0 100%; } }
.viewer { width: 96vw; max-width: none; height: 96vh; max-height: none; border: 0; border-radius: .5rem; background: var(--page); color: var(--text); }
.viewer[open] { display: flex; flex-direction: column; gap: .25rem; } .viewer canvas { flex: 1; min-height: 0; width: 100%; touch-action: none; background: var(--soft); }
.viewer h2, .viewer p { margin: 0; max-width: none; } .viewer [aria-pressed=true] { font-weight: 650; border-color: var(--link); }
.small { display: block; width: 10rem; height: auto; border-radius: .25rem; }
.beside { display: grid; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); gap: 0 1.5rem; } body:has(.beside) { max-width: 110rem; }
.source { font: .8125rem/1.45 ui-monospace, "SFMono-Regular", Menlo, Consolas, "DejaVu Sans Mono", monospace; padding-left: 3.5rem; white-space: pre-wrap; overflow-wrap: anywhere; }
.source li { min-height: 1.45em; margin: 0; } .source li::marker { color: var(--quiet); } .source .shared { background: var(--part-soft); } .source .given { opacity: .5; }
@media (max-width: 40rem) {
.overview th, .overview td { padding-right: .5rem; }
.wide .cases { min-width: 0; } .cases thead { display: none; } .cases, .cases tbody { display: block; }
.cases tr { display: grid; grid-template: "no name points" "no badge badge" "no saw saw" / 3.25rem 1fr auto; gap: .2rem .5rem; padding: .5rem 0; }
.cases tr > * { border: 0; padding: 0; } .cases td:nth-child(1) { grid-area: no; } .cases th { grid-area: name; } .cases td:nth-child(3) { grid-area: badge; }
.cases td:nth-child(4) { grid-area: points; } .cases td:nth-child(5) { grid-area: saw; } .cases pre { white-space: pre-wrap; }
}
@media screen and (min-width: 75rem) {
body:has(main > * > .overview) { max-width: 130rem; } main:has(> * > .overview) { display: grid; grid-template-columns: 22rem minmax(0, 1fr); gap: 0 2.5rem; align-items: start; }
main:has(> * > .overview) > * { grid-column: 2; } main > :has(> .overview) { grid-area: 1 / 1 / span 99; position: sticky; top: 1rem; } .category { width: 20%; } .saw { width: 55%; }
}
@media screen and (min-width: 100rem) {
main:has(.class):not(:has(> .fold :checked)) { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 0 3rem; align-items: start; }
main:has(.class) > :is(.fold, [id=submissions], [id=hand-ins], [id=pictures]) { grid-column: 1 / -1; }
}
/* A row is a card: it fits a telephone and a sheet of paper. */
@media (max-width: 40rem), print {
.wide .class { min-width: 0; } .class thead { display: none; } .class, .class tbody { display: block; }
.class tr { display: flex; flex-wrap: wrap; gap: .3rem .75rem; padding: .6rem 0; border-bottom: 1px solid var(--line); } .class tr > * { border: 0; padding: 0; }
.class tbody th { flex: 1 0 70%; } .class td[data-id]::before { content: attr(data-id) " "; color: var(--quiet); font-size: .8125rem; } .class tbody a.badge { min-width: 3rem; }
}
.view #picture { display: block; width: 100%; aspect-ratio: 16 / 9; max-height: 62vh; border-radius: .375rem; touch-action: none; cursor: grab; }
.view #picture:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; } .view #note:empty { display: none; } body:has(.view) { max-width: 72rem; }
.framed body { padding: 0; background: none; } .framed :is(h1, h2, #plots, #words, #words ~ p) { display: none; }
.controls { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: center; margin: .6rem 0; } .controls input[type=range] { flex: 1 1 12rem; min-width: 8rem; }
.controls button { min-width: 4.5rem; } .controls label { max-width: 100%; overflow-wrap: anywhere; } .controls button, .controls select { font: inherit; } .controls select { max-width: 14rem; }
#moment { max-width: none; font-variant-numeric: tabular-nums; } #plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(19rem, 1fr)); gap: .5rem 1.5rem; }
.plot canvas { display: block; width: 100%; height: 9rem; border: 0 solid var(--line); cursor: crosshair; touch-action: pan-y; }
.plot div { position: relative; overflow: hidden; } .plot i { position: absolute; top: 8px; bottom: 20px; left: 0; border-left: 1px solid; pointer-events: none; }
@media print { body { max-width: none; padding: 0; } figure, tr { break-inside: avoid; } h2 { break-after: avoid; } .badge, .note, .stamp { border: 1px solid; } }
)css";

}  // namespace

HtmlPart::HtmlPart(const char* text) : html_(escaped(text)) {}
HtmlPart::HtmlPart(const std::string& text) : html_(escaped(text)) {}
HtmlPart::HtmlPart(std::string_view text) : html_(escaped(text)) {}

Html html(std::string_view pattern, std::initializer_list<HtmlPart> parts) {
  Html result;
  auto part = parts.begin();
  for (std::size_t hole = pattern.find("{}"); hole != std::string_view::npos; hole = pattern.find("{}")) {
    if (part == parts.end()) throw std::invalid_argument("an HTML pattern has more holes than parts");
    result.text += pattern.substr(0, hole);
    result.text += part->html();
    ++part;
    pattern.remove_prefix(hole + 2);
  }
  if (part != parts.end()) throw std::invalid_argument("an HTML pattern has fewer holes than parts");
  result.text += pattern;
  return result;
}

std::string html_page(const std::string& title, const Html& body, const Scripts& scripts, Pictures pictures) {
  // For a page that is a file, not every browser accepts the page's own folder as 'self'.
  std::string policy = std::string("default-src 'none'; img-src ") +
                       (pictures == Pictures::inside ? "data:" : "'self' file:") +
                       "; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'" +
                       (scripts.texts.empty() ? "" : "; script-src");
  Html elements;
  for (const std::string& text : scripts.texts) {
    policy += " 'sha256-" + base64(sha256_bytes(text)) + "'";
    elements += html("<script>{}</script>\n", {Html{text}});
  }
  if (scripts.asks) policy += "; connect-src 'self'";
  return html(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta http-equiv="Content-Security-Policy" content="{}"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>{}</title>
<style>{}</style>
</head>
<body>
{}{}</body>
</html>
)",
              {policy, title, Html{std::string(style)}, body, elements})
      .text;
}

}  // namespace hair
