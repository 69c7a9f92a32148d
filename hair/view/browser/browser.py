# STAFF ONLY. Pages in headless Chromium, by Debian's chromium-driver and python3-selenium.
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    print("selenium is missing: pages are not opened in a browser (grader/setup.sh --with browser)")
    sys.exit(77)

HAIRLAB = os.environ.get("HAIRLAB")
AXE = "axe-core@4.10.3"  # finds what keeps people from using a page
WAIT = 300  # s; a machine may be busy

# Debian's chromium without a card, and without the network.
FLAGS = """--headless --no-sandbox --disable-dev-shm-usage --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --disable-extensions
--window-size=1000,1100""".split()
NO_NAMES = "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1"
WITH_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis"]


def start_browser(flags):
    options = webdriver.ChromeOptions()
    for flag in FLAGS + [NO_NAMES] + flags:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    driver.set_script_timeout(WAIT)
    return driver


class PageTest(unittest.TestCase):
    """One browser for the tests of a class; the run that its pages show is made once."""

    flags = WITH_WEBGL

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="hair-browser-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.driver = start_browser(cls.flags)
        cls.addClassCleanup(cls.driver.quit)

    def run_script(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait_for(self, script, *arguments):
        return WebDriverWait(self.driver, WAIT, 0.1).until(lambda _: self.run_script(script, *arguments))

    def text(self, name):
        return self.run_script("return document.getElementById(arguments[0]).textContent", name)

    def set_width(self, width):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})

    def press(self, *keys):
        chain = webdriver.ActionChains(self.driver)
        for key in keys:
            chain.send_keys(key)
        chain.perform()

    def complaints(self):
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def check_no_sideways_scroll(self):
        for width in (390, 1280, 2560):
            self.set_width(width)
            self.wait_for("return innerWidth === arguments[0]", width)
            self.driver.execute_async_script("const [done] = arguments; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 200)))")
            with self.subTest(width=width):
                wide = self.run_script("""return [...document.querySelectorAll("body, body *")]
                    .filter((one) => one.getBoundingClientRect().right > innerWidth + 0.5)
                    .map((one) => one.tagName + "#" + one.id)""")
                self.assertEqual(wide, [])
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), width)
        self.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def check_no_findings_of_axe(self):
        try:
            subprocess.run(["npm", "install", "--no-save", "--no-package-lock", "--ignore-scripts", "--no-audit", "--no-fund", AXE], cwd=self.folder.name, check=True,
                           capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest(f"npm does not install {AXE}")
        self.run_script(Path(self.folder.name, "node_modules/axe-core/axe.min.js").read_text(encoding="utf-8"))
        self.assertEqual(self.driver.execute_async_script("""const [done] = arguments;
            axe.run().then((found) => done(found.violations.map((one) =>
              [one.id, one.impact, one.help, ...one.nodes.map((node) => node.html)])))"""), [])

    # The part of the picture that is hair, or anything except its background.
    def share_drawn(self):
        png = self.driver.find_element("id", "picture").screenshot_as_base64
        return self.driver.execute_async_script("""
            const [png, done] = arguments, image = new Image();
            image.onload = () => {
              const canvas = document.createElement("canvas");
              [canvas.width, canvas.height] = [image.width, image.height];
              const pen = canvas.getContext("2d");
              pen.drawImage(image, 0, 0);
              const { data } = pen.getImageData(0, 0, image.width, image.height);
              const middle = 4 * Math.floor(image.width / 2 + image.width * 5);
              let other = 0;
              for (let i = 0; i < data.length; i += 4)
                if (Math.abs(data[i] - data[middle]) + Math.abs(data[i + 1] - data[middle + 1]) +
                    Math.abs(data[i + 2] - data[middle + 2]) > 60) ++other;
              done(other / (data.length / 4));
            };
            image.src = "data:image/png;base64," + png;""", png)

    # Names of the elements that the Tab key reaches, from the page's top to its end.
    def reached_by_tab(self):
        self.run_script("document.activeElement.blur(); window.scrollTo(0, 0)")
        reached = []
        while True:
            self.press("\ue004")
            name = self.run_script("return document.activeElement === document.body ? null : document.activeElement.id || document.activeElement.tagName")
            if name is None or name in reached:
                return reached
            reached.append(name)

    def go_to(self, name):
        self.run_script("document.activeElement.blur()")
        for _ in range(40):
            self.press("\ue004")
            if self.run_script("return document.activeElement.id") == name:
                return
        self.fail(f"the Tab key does not reach {name}")


def hairlab(*words, **settings):
    return subprocess.run([HAIRLAB, *map(str, words)], check=True, capture_output=True, text=True, **settings)


def main():
    if not Path("/usr/bin/chromedriver").exists():
        print("chromedriver is missing: pages are not opened in a browser (grader/setup.sh --with browser)")
        sys.exit(77)
    unittest.main(verbosity=2)
