// STAFF ONLY. Makes the handout's pages: "node pages.js FOLDER A.md B.md ..." writes A.html beside A.md, which
// asks for no other file. Formulas become MathML, and the font for them holds only the glyphs that they need.
// Ends with 77 and a line if a package is missing (grader/setup.sh --with pages), and with 1 for a bad text.
"use strict";
const { execFileSync } = require("child_process");
const fs = require("fs");
const path = require("path");

const kLatinModern = "/usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf";
const kLicence = "/usr/share/texmf/doc/fonts/lm-math/GUST-FONT-LICENSE.txt";
const kLicenceHere = "assignment/font-licence.txt";
const [folder, ...texts] = process.argv.slice(2);

function needed(what, make) {
  try {
    return make();
  } catch (error) {
    console.log(what + " is missing");
    return process.exit(77);
  }
}
const katex = needed("katex", () => require("katex"));
const { marked } = needed("node-marked", () => require("marked"));
needed("fonts-lmodern", () => fs.copyFileSync(kLicence, path.join(folder, kLicenceHere)));

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");

// KaTeX writes more than browsers know: of mathvariant "normal" alone (the style sheet makes letters bold), no
// minus without a left side, no space behind a function's name, no bars that embrace.
function mathml(tex, displayMode) {
  const html = katex.renderToString(tex, { displayMode, output: "mathml", strict: "ignore" })
    .replace(/<annotation[^]*?<\/annotation>|<\/?(semantics|span)[^>]*>/g, "")
    .replace(/<mo>(?=[^<]*<\/mo><\/mover>)/g, '<mo stretchy="false">')
    .replace(/(<mo[^>]*>[^)\]}|∥!⌋<]+<\/mo>)<mo>(?=[−+]<)/g, '$1<mo form="prefix">')
    .replace(/<mo>\u2061<\/mo>(?!<mo|<\/)/g, '<mspace width=".17em"></mspace>')
    .replace(/<mo( [^>]+)>(?=[∥∣])/g, '<mo$1 lspace="0" rspace="0">')
    .replace(/\u20d7/g, "→").replace(/[\u02c9\u203e]/g, "¯")
    .replace(/<mo>([−+])<\/mo><mo>=/g, "<mo>$1=")
    .replace(/<mi mathvariant="double-struck">([A-Z])/g, (_, letter) => "<mi>" + ("CHNPQRZ".includes(letter)
      ? "ℂℍℕℙℚℝℤ"["CHNPQRZ".indexOf(letter)] : String.fromCodePoint(letter.charCodeAt(0) - 65 + 0x1d538)));
  const other = /mathvariant="(?!normal|bold|italic)([^"]*)/.exec(html);
  if (other) throw new Error(`no browser shows the ${other[1]} letters of ${tex}`);
  return html;
}

// Markdown sees a mark in a formula's place, so that no letter of the formula means something to it.
const kFormula = /^ *(```+|~~~+)[^]*?^ *\1|(`+)(?:(?!\n\n)[^])*?[^`]\2(?!`)|\\[^]|\$\$([^]+?)\$\$|\$(?![\s$])((?:(?!\n\n)[^$\\]|\\[^])*?)(?:(?<!\s)|(?=\$\W))\$(?!\d)/gm;
const kMark = /\ue000(\d+)\ue001/g, kMarkAndSigns = /(\(*)(\ue000(\d+)\ue001)([.,;:?!)]*)/g;

function body_of(text) {
  const formulas = [], here = path.dirname(text);
  const markdown = fs.readFileSync(path.join(folder, text), "utf8").replace(kFormula, (all, fence, ticks, block, inline) => {
    const tex = block || inline;
    if (!tex) return all;
    let html = mathml(tex, Boolean(block));
    const long = html.replace(/<[^>]*>/g, "").length > 24;
    if (block || long) html = `<span class="${block ? "formula" : "long"}">${html}</span>`;
    return `\ue000${formulas.push({ tex, html }) - 1}\ue001`;
  });
  const as_tex = (words) => words.replace(kMark, (_, i) => formulas[i].tex);
  const renderer = Object.assign(new marked.Renderer(), {
    heading: (html, level, raw, slugger) => `<h${level} id="${slugger.slug(as_tex(raw))}">${html}</h${level}>\n`,
    table: (head, rows) => `<div class="wide"><table><thead>${head}</thead><tbody>${rows}</tbody></table></div>\n`,
    link: (href, title, words) => `<a href="${escaped(href.replace(/^([^:#]+)\.md(?=#|$)/, (all, name) =>
      texts.includes(path.join(here, name + ".md")) ? name + ".html" : all))}">${words}</a>`,
    image(href, title, words) {
      const bytes = fs.readFileSync(path.join(folder, here, href)), svg = href.endsWith(".svg");
      const paper = svg && !bytes.includes("prefers-color-scheme") ? "paper" : "";
      return `<span class="wide"><img class="${svg ? "drawing" : ""} ${paper}" alt="${escaped(as_tex(words))}"` +
        ` src="data:image/${svg ? "svg+xml" : "png"};base64,${bytes.toString("base64")}"></span>`;
    },
  });
  return marked.parse(markdown, { renderer, mangle: false }).replace(kMarkAndSigns, (_, before, mark, i, after) =>
    before + after ? `<span class="whole">${before}${formulas[i].html}${after}</span>` : formulas[i].html);
}

// Returns a style sheet's rule with the font's glyphs for these pages; a letter alone becomes italic.
function font_for(pages) {
  const used = new Set(["√"]);
  for (const page of pages)
    for (const formula of page.match(/<math[^]*?<\/math>/g) || [])
      for (const letter of formula.replace(/<[^>]*>/g, "").replace(/&[a-z]+;|&#\w+;/g, "<>&")) used.add(letter);
  for (let code = 0x1d434; code <= 0x1d71b; ++code)
    if ((code < 0x1d468 || code > 0x1d6e1) && used.has(String.fromCodePoint(code).normalize("NFKC")))
      used.add(String.fromCodePoint(code));
  used.add("ℎ").add("𝜙");
  const out = path.join(folder, "font.woff2");
  needed("fonttools with python3-brotli", () => execFileSync("pyftsubset", [kLatinModern, "--flavor=woff2", "--no-hinting",
    "--desubroutinize", "--layout-features=", "--output-file=" + out, "--text=" + [...used].sort().join("")], { stdio: "pipe" }));
  return `@font-face { font-family: "Formulas"; src: url(data:font/woff2;base64,${fs.readFileSync(out, "base64")}); }`;
}

const bodies = texts.map((text) => {
  try {
    return body_of(text);
  } catch (error) {
    console.log(`${text}: ${error.message}`);
    return process.exit(1);
  }
});
const font = font_for(bodies), style = fs.readFileSync(path.join(__dirname, "pages.css"), "utf8").replace(/\/\*[^]*?\*\/\s*/g, "");
texts.forEach((text, i) => {
  const maths = bodies[i].includes("<math"), to = (file) => path.relative(path.dirname(text), file);
  const title = (/<h1[^>]*>([^]*?)<\/h1>/.exec(bodies[i]) || ["", text])[1].replace(/<[^>]*>/g, "");
  const places = [["README", "Handout"], ["assignment/README", "Exercises"]].filter(([file]) => texts.includes(file + ".md"))
    .map(([file, name]) => `<a href="${to(file + ".html")}">${name}</a>`);
  fs.writeFileSync(path.join(folder, text.replace(/md$/, "html")), `<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>${title}</title>
<style>
${style}${maths ? font : ""}
</style>
<nav>${places.join(" ")}</nav>
<main>
${bodies[i]}</main>
${maths ? `<footer>Formulas are set in a part of Latin Modern Math, under the <a href="${to(kLicenceHere)}">GUST Font License</a>.</footer>\n` : ""}</html>
`);
});
