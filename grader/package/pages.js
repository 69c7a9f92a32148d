// STAFF ONLY. Makes the handout's pages: "node pages.js FOLDER A.md B.md ..." writes A.html beside A.md, which
// asks for no other file. Ends with 77 and a line if a package is missing, with 1 and a line for a bad text.
"use strict";
const { execFileSync } = require("child_process");
const fs = require("fs");
const path = require("path");

const kFont = "/usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf";
const kLicence = "/usr/share/texmf/doc/fonts/lm-math/GUST-FONT-LICENSE.txt", kLicenceHere = "assignment/font-licence.txt";
const [folder, ...texts] = process.argv.slice(2), here = (file) => path.join(folder, file);

function or_end(code, line, make) {
  try { return make(); } catch (error) {
    console.log(code === 77 ? line : `${line}: ${error.message}`);
    return process.exit(code);
  }
}
const katex = or_end(77, "katex is missing", () => require("katex"));
const { marked } = or_end(77, "node-marked is missing", () => require("marked"));
or_end(77, "fonts-lmodern is missing", () => fs.copyFileSync(kLicence, here(kLicenceHere)));

// KaTeX writes more than browsers know: of mathvariant "normal" alone (the style sheet makes letters bold), no
// minus without a left side, no space behind a function's name, no bars that embrace.
function mathml(tex, displayMode) {
  const html = katex.renderToString(tex, { displayMode, output: "mathml", strict: "ignore" })
    .replace(/<annotation[^]*?<\/annotation>|<\/?(semantics|span)[^>]*>/g, "")
    .replace(/<mo>(?=[^<]*<\/mo><\/mover>)/g, '<mo stretchy="false">')
    .replace(/(<mo[^>]*>[^)\]}|∥!⌋<]+<\/mo>)<mo>(?=[−+]<)/g, '$1<mo form="prefix">')
    .replace(/<mo>\u2061<\/mo>(?!<mo|<\/)/g, '<mspace width=".17em"></mspace>')
    .replace(/<mi mathvariant="normal">∣<\/mi>/g, '<mo stretchy="false">∣</mo>')
    .replace(/<mo( [^>]+)>(?=[∥∣])/g, '<mo$1 lspace="0" rspace="0">')
    .replace(/<mo mathvariant="normal"[^>]*>′<\/mo>/g,
      '<mpadded voffset="-.45em"><mi class="prime" mathvariant="normal">′</mi></mpadded>')
    .replace(/\u20d7/g, "→").replace(/[\u02c9\u203e]/g, "¯")
    .replace(/<mo>([−+])<\/mo><mo>=/g, "<mo>$1=")
    .replace(/<mi mathvariant="double-struck">([A-Z])/g, (_, letter) => "<mi>" + ("CHNPQRZ".includes(letter)
      ? "ℂℍℕℙℚℝℤ"["CHNPQRZ".indexOf(letter)] : String.fromCodePoint(letter.charCodeAt(0) - 65 + 0x1d538)));
  const other = /mathvariant="(?!normal|bold|italic)([^"]*)/.exec(html);
  if (other) throw new Error(`no browser shows the ${other[1]} letters of ${tex}`);
  return html;
}

// Markdown sees a mark in a formula's place, so that no letter of the formula means something to it.
const kFormula = new RegExp(["^ *(```+|~~~+)[^]*?^ *\\1", "(`+)(?:(?!\\n\\n)[^])*?[^`]\\2(?!`)", "\\\\[^]",
  "\\$\\$([^]+?)\\$\\$", "\\$(?![\\s$])((?:(?!\\n\\n)[^$\\\\]|\\\\[^])*?)(?:(?<!\\s)|(?=\\$\\W))\\$(?!\\d)"].join("|"), "gm");
const kMark = /\ue000(\d+)\ue001/g, kMarkAndSigns = /(\(*)\ue000(\d+)\ue001([.,;:?!)]*)/g;

const kView = `<iframe src="view.html" loading="lazy" title="A right run, and one with a usual mistake"></iframe>
<p><a href="view.html">The same with curves of its measures</a>.</p>
`;
const quoted = (words) => words.replace(/"/g, "&quot;").replace(/</g, "&lt;");

function body_of(text) {
  const formulas = [], beside = (file) => path.join(path.dirname(text), file);
  const markdown = fs.readFileSync(here(text), "utf8").replace(kFormula, (all, fence, ticks, block, inline) => {
    const tex = block || inline;
    if (!tex) return all;  // code, or an escaped character
    const html = mathml(tex, Boolean(block)), long = html.replace(/<[^>]*>/g, "").length > 24;
    const span = block ? '<span class="formula">' : long ? '<span class="long">' : "";
    return `\ue000${formulas.push({ tex, html: span + html + (span && "</span>") }) - 1}\ue001`;
  });
  const as_tex = (words) => words.replace(kMark, (_, i) => formulas[i].tex);
  const renderer = Object.assign(new marked.Renderer(), {
    heading: (html, level, raw, slugger) => `<h${level} id="${slugger.slug(as_tex(raw))}">${html}</h${level}>\n`,
    table: (head, rows) => `<div class="wide"><table><thead>${head}</thead><tbody>${rows}</tbody></table></div>\n`,
    html(raw) {
      if (/^<!--[^]*-->\s*$/.test(raw)) return "";
      throw new Error("HTML stands in it: " + raw.trim().slice(0, 60));
    },
    link: (href, title, words) => `<a href="${quoted(href).replace(/^([^:#]+)\.md(?=#|$)/, (all, name) =>
      texts.includes(beside(all)) ? name + ".html" : all)}">${words}</a>`,
    image(href, title, words) {
      if (beside(href).startsWith("..")) throw new Error(href + " lies outside of the handout");
      const bytes = fs.readFileSync(here(beside(href))), svg = href.endsWith(".svg");
      return `<span class="wide"><img class="${svg ? "drawing" : "photo"}" alt="${quoted(as_tex(words))}" src="data:image/${
        svg ? "svg+xml" : "png"};base64,${bytes.toString("base64")}"></span>`;
    },
  });
  const view = fs.existsSync(here(beside("view.html"))) ? kView : "";
  return marked.parse(markdown, { renderer, mangle: false }).replace(/<h2 id="look-at-it">.*\n/, "$&" + view).replace(kMarkAndSigns, (_, before, i, after) =>
    before + after ? `<span class="whole">${before}${formulas[i].html}${after}</span>` : formulas[i].html);
}

// Returns a rule with the glyphs that these pages need; a letter alone is italic.
function font_for(pages) {
  const formulas = pages.join().match(/<math[^]*?<\/math>/g) || [], out = here("font.woff2");
  const used = new Set("√ℎ𝜙<>&" + formulas.join("").replace(/<[^>]*>/g, ""));
  for (let code = 0x1d434; code <= 0x1d71b; ++code)
    if ((code < 0x1d468 || code > 0x1d6e1) && used.has(String.fromCodePoint(code).normalize("NFKC")))
      used.add(String.fromCodePoint(code));
  or_end(77, "fonttools or python3-brotli is missing", () => execFileSync("pyftsubset", [kFont, "--flavor=woff2",
    "--no-hinting", "--desubroutinize", "--layout-features=", "--output-file=" + out,
    "--text=" + [...used].sort().join("")], { stdio: "pipe" }));
  return `@font-face { font-family: Formulas; src: url(data:font/woff2;base64,${fs.readFileSync(out, "base64")}); }`;
}

const bodies = texts.map((text) => or_end(1, text + " can't become a page", () => body_of(text)));
const font = font_for(bodies), style = fs.readFileSync(path.join(__dirname, "pages.css"), "utf8");
texts.forEach((text, i) => {
  const maths = bodies[i].includes("<math"), to = (file) => path.relative(path.dirname(text), file);
  fs.writeFileSync(here(text.replace(/md$/, "html")), `<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>${(/<h1[^>]*>([^]*?)<\/h1>/.exec(bodies[i]) || ["", text])[1].replace(/<[^>]*>/g, "")}</title>
<style>${style.replace(/\/\*[^]*?\*\//g, "")}${maths ? font : ""}</style>
<nav><a href="${to("README.html")}">Handout</a> <a href="${to("assignment/README.html")}">Exercises</a></nav>
<main>
${bodies[i]}</main>
${maths ? `<footer>Formulas are set in a part of Latin Modern Math, under the <a href="${to(kLicenceHere)}">GUST Font License</a>.</footer>\n` : ""}`);
});
