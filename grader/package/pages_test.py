# STAFF ONLY. Opens the handout's pages in browsers: Chromium, and Firefox where it is installed.
import json
import os
import re
import shutil
import socket
import subprocess
import unittest
from pathlib import Path

from browser import PageTest, main

MOST_BYTES = 250_000  # of a page without its pictures
FRAME = '<iframe width="{}" height="900" style="border: 0; color-scheme: {}" src="{}">'  # any width, any theme
FAULTS = """const [dark] = arguments, all = (what) => [...document.querySelectorAll(what)], faults = [];
  const words = document.body.cloneNode(true), high = (one) => one.getBoundingClientRect().height;
  words.querySelectorAll("code").forEach((one) => one.remove());
  for (const [mark] of words.textContent.matchAll(/[\\\\$\\ue000].{0,20}/g)) faults.push("in the text: " + mark);
  // No browser reports what a page of a file asks for: nothing in it may.
  for (const one of all("[src], [srcset], link, object"))
    if (!/^data:|^view[.]html$/.test(one.getAttribute("src"))) faults.push("asks for " + one.outerHTML);
  for (const [url] of all("style")[0].textContent.matchAll(/(url.|@import)(?!data:).{20}/g)) faults.push("asks for " + url);
  if (document.documentElement.scrollWidth > innerWidth) faults.push("is wider than " + innerWidth);
  for (const image of all("img")) if (!image.naturalWidth || !image.alt) faults.push("a picture fails: " + image.alt);
  const { color, backgroundColor: paper } = getComputedStyle(document.documentElement);
  const bright = (rgb) => /\\d+/.exec(rgb) > 128;
  if (bright(color) !== dark || bright(paper) === dark) faults.push(`${color} on ${paper}`);
  return document.fonts.ready.then((fonts) => {
    if (all("math").length && ![...fonts].some((one) => one.status === "loaded")) faults.push("has no font for formulas");
    // TeX, too, lets a bracket cover 0.9 of its matrix.
    for (const table of all("mo + mtable"))
      for (const side of [table.previousElementSibling, table.nextElementSibling])
        if (side?.localName === "mo" && "()[]{|".includes(side.textContent) && high(side) < 0.9 * high(table))
          faults.push(`${side.textContent} is ${high(side)} high, and its matrix ${high(table)}`);
    return faults;
  });"""


class Firefox:
    """Debian has no driver for it: this speaks its own language, Marionette."""

    def __init__(self, profile, at_end):
        profile.mkdir()
        (profile / "user.js").write_text('user_pref("marionette.port", 0);', encoding="utf-8")
        self.process = subprocess.Popen(["firefox-esr", "--headless", "--marionette", "--profile", profile], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        at_end(lambda: (self.process.terminate(), self.process.wait()))
        port = next(line.split()[-1] for line in self.process.stdout if b"Listening on port" in line)
        self.stream = socket.create_connection(("127.0.0.1", int(port))).makefile("rwb")
        self.answer()
        self.ask("NewSession")

    def answer(self):
        length = b"".join(iter(lambda: self.stream.read(1), b":"))
        return json.loads(self.stream.read(int(length)))

    def ask(self, command, **arguments):
        words = json.dumps([0, 1, "WebDriver:" + command, arguments]).encode()
        self.stream.write(b"%d:%s" % (len(words), words))
        self.stream.flush()
        _, _, error, result = self.answer()
        return error or result.get("value")

    def look(self, page, *arguments):
        self.ask("Navigate", url=page)
        self.ask("SwitchToFrame", id=0)
        return self.ask("ExecuteScript", script=FAULTS, args=arguments)


class TextsPages(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        archive = Path(cls.folder.name, "handout.tar.gz")
        packed = subprocess.run([os.environ["HAIRGRADE"], "handout", "--out", archive], check=True, capture_output=True, text=True)
        if packed.stderr:
            raise unittest.SkipTest(packed.stderr)
        shutil.unpack_archive(archive, cls.folder.name)
        cls.top = Path(cls.folder.name, "hair-assignment")
        cls.pages = {page: page.read_text(encoding="utf-8") for page in sorted(cls.top.rglob("*.html")) if page.name != "view.html"}

    def check_all(self, browser):
        frame = Path(self.folder.name, "frame.html")
        for page in self.pages:
            for width, theme in ((390, "light"), (390, "dark"), (1280, "light"), (1280, "dark")):
                frame.write_text(FRAME.format(width, theme, page.as_uri()), encoding="utf-8")
                with self.subTest(page=str(page.relative_to(self.top)), width=width, theme=theme):
                    self.assertEqual(browser.look(frame.as_uri(), theme == "dark"), [])

    def look(self, page, *arguments):
        self.driver.get(page)
        self.driver.switch_to.frame(0)
        return self.run_script(FAULTS, *arguments)

    def test_reads_well_in_chromium(self):
        self.check_all(self)

    def test_reads_well_in_firefox(self):
        if not shutil.which("firefox-esr"):
            self.skipTest("firefox-esr is missing: pages are not opened in it")
        self.check_all(Firefox(Path(self.folder.name, "firefox"), self.addCleanup))

    def test_plays_a_mistake_beside_the_right_run_of_each_exercise_with_a_scene(self):
        views = sorted(self.top.rglob("view.html"))
        exercises = {page.parent for page in self.pages if page.name == "text.html"}
        self.assertEqual({page.parent for page in views}, exercises - {self.top / "exercises/S2"})
        for view in views:
            with self.subTest(exercise=view.parent.name):
                self.assertIn('<iframe src="view.html"', self.pages[view.with_name("text.html")])
                self.driver.get(view.as_uri())
                self.wait_for("return window.hairView && hairView.pictures > 0")
                self.assertRegex(self.run_script("return hairView.runs[1].shows"), r"^Wrong: .*\.$")
                self.assertGreater(self.run_script("return Math.max(...hairView.apart.values)"), 1)
                scene = json.loads(re.search('id="motion".*?>({.*})', view.read_text(encoding="utf-8"))[1])
                motion = json.loads(Path(self.top, "given/hair/motions", scene["name"] + ".json").read_text("utf-8"))
                for key in ("shows", "camera", "times"):
                    self.assertEqual(scene[key], motion[key], "the scene has changed: build the target mistakes")
                self.assertEqual(self.complaints(), [])

    def test_plays_a_view_in_its_page_again_and_again(self):
        self.driver.get((self.top / "exercises/H1/text.html").as_uri())
        self.run_script("document.querySelector('iframe').scrollIntoView()")
        self.driver.switch_to.frame(self.driver.find_element("css selector", "iframe"))
        self.wait_for("return window.hairView && hairView.pictures > 0")
        self.run_script("hairView.seek(1e9)")
        self.wait_for("return hairView.clock.playing && hairView.clock.time < 1")
        self.assertEqual(self.run_script("return [...document.querySelectorAll('h1, #plots, #words')].some((one) => one.checkVisibility())"), False)

    def test_leads_to_what_is_there_and_stays_small(self):
        self.assertEqual({page.with_suffix(".md") for page in self.pages}, set(self.top.rglob("*.md")))
        for page, text in self.pages.items():
            self.assertLess(len(re.sub('"data:image[^"]*"', "", text).encode()), MOST_BYTES, page)
            for name, place in re.findall('<a href="(?!http)([^"#]*)(?:#([^"]*))?"', text):
                target = (page.parent / name).resolve() if name else page
                with self.subTest(page=str(page.relative_to(self.top)), link=name, place=place):
                    self.assertTrue(target.exists())
                    self.assertIn(f'id="{place}"' if place else "", self.pages.get(target, ""))


if __name__ == "__main__":
    main()
