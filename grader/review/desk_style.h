// STAFF ONLY. The style of the desk's page, beside that of all pages (hair/io/plot/html.cpp).
#pragma once

namespace grader::inline review {

inline constexpr const char* kDeskStyle = R"css(
body:has(.desk) { max-width: none; padding: 1rem 1.5rem; }
.top { display: flex; flex-wrap: wrap; gap: .25rem 2rem; align-items: baseline; margin-bottom: 1rem; }
.top h1 { font-size: 1.25rem; } .top .line:last-child { margin-left: auto; } #progress { color: var(--quiet); } #progress strong { color: var(--text); font-weight: 600; }
.desk { display: grid; grid-template-columns: minmax(19rem, 24rem) minmax(0, 1fr); gap: 2rem; align-items: start; }
.side { position: sticky; top: 1rem; display: flex; flex-direction: column; max-height: calc(100vh - 5.5rem); }
.desk button, .desk select, .desk input, .desk textarea, dialog button, dialog input, dialog select, dialog textarea, .top button { font: inherit; font-size: .9375rem; color: inherit;
  background: var(--page); border: 1px solid var(--line); border-radius: .375rem; padding: .3rem .6rem; max-width: 100%; }
.desk button, dialog button, .top button { background: var(--soft); cursor: pointer; } .desk button:hover, dialog button:hover { border-color: var(--link); }
:is(.desk, dialog, .top) :is(button, a, input, select, textarea):focus-visible { outline: 2px solid var(--link); outline-offset: 1px; }
kbd { font: .75rem ui-monospace, Menlo, Consolas, monospace; padding: 0 .3rem; border: 1px solid var(--line); border-radius: .25rem; color: var(--quiet); background: var(--page); }
.no-keys kbd { display: none; }
.filters { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: .4rem; } .filters label { align-self: center; font-size: .9375rem; } #search { grid-column: 1 / 3; }
.steps { display: flex; flex-wrap: wrap; gap: .35rem; margin-top: .4rem; } .steps button { padding: .3rem .45rem; } #count { font-size: .875rem; }
#list { list-style: none; margin: 0; padding: 0; overflow-y: auto; min-height: 6rem; border: 1px solid var(--line); border-radius: .375rem; }
#list a { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 0 .75rem; padding: .4rem .75rem; color: inherit; text-decoration: none; border-bottom: 1px solid var(--line); font-size: .9375rem; line-height: 1.4; border-left: .25rem solid transparent; }
#list a:hover { background: var(--soft); } #list [aria-current] { background: var(--soft); border-left-color: var(--link); } #list .name { font-weight: 550; overflow-wrap: anywhere; } #list .quiet { font-size: .8125rem; }
#list .decided .name { font-weight: 400; color: var(--quiet); } #list .decided .name::before { content: "\2713  "; color: var(--good); }
#item h2 { margin: .25rem 0; font-size: 1.5rem; overflow-wrap: anywhere; } #item h2:focus { outline: none; } #item blockquote { margin: .75rem 0; padding: .5rem 1rem; border-left: .25rem solid var(--link); background: var(--soft); white-space: pre-wrap; overflow-wrap: anywhere; }
#item > article > header .note { margin: .5rem 0; padding: .4rem .75rem; }
.actions { position: sticky; top: 0; z-index: 1; display: flex; flex-wrap: wrap; gap: .5rem; padding: .6rem 0; background: var(--page); border-bottom: 1px solid var(--line); }
.actions button:first-child { background: var(--link); border-color: var(--link); color: var(--page); font-weight: 600; }
.what .wide table { min-width: 0; } .what td:last-child { overflow-wrap: anywhere; } #item .what h2 { margin-top: 1.25rem; font-size: 1.25rem; }
#told { max-width: none; margin: 0; } #told:not(:empty) { margin-bottom: .75rem; padding: .5rem .75rem; border-radius: .375rem; background: var(--soft); } #told.bad { background: var(--bad-soft); color: var(--bad); }
dialog { width: min(40rem, calc(100vw - 2rem)); max-height: calc(100vh - 4rem); padding: 1.25rem 1.5rem; color: var(--text); background: var(--page); border: 1px solid var(--line); border-radius: .5rem; box-shadow: 0 1rem 3rem #0006; }
dialog::backdrop { background: #0008; } dialog h2, dialog h3 { margin: 0 0 .75rem; font-size: 1.125rem; } dialog label { display: block; margin: .6rem 0; } dialog :is(textarea, select) { display: block; width: 100%; }
.used:focus { outline: none; } .cases td:first-child { white-space: nowrap; } dialog .told:empty { display: none; } dialog .told { color: var(--bad); } .used { list-style: none; margin: .25rem 0 1rem; padding: 0; max-height: 16rem; overflow-y: auto; } .used button { width: 100%; margin: .15rem 0; text-align: left; white-space: pre-wrap; overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: auto 1fr; gap: .35rem 1rem; } dd { margin: 0; } .buttons { display: flex; flex-wrap: wrap; gap: .5rem; }
@media (min-width: 100rem) { .desk { grid-template-columns: 28rem minmax(0, 1fr); } .what { max-width: 110rem; } }
@media (max-width: 56rem) { body:has(.desk) { padding: .75rem 1rem; } .desk { grid-template-columns: minmax(0, 1fr); gap: .75rem; } .side { position: static; max-height: none; } #list { max-height: 9rem; min-height: 4rem; } #item h2 { font-size: 1.25rem; } .top { gap: .25rem 1rem; } }
)css";

}  // namespace grader::review
