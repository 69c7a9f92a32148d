# STAFF ONLY. How many pictures a second the page of `hairlab view` draws, without a card:
# HAIRLAB=build/release/hairlab frame_rate.py. Writes the rows of hair/MEASURED.md.
import array
import base64
import json
import math
import os
import random
import statistics
import tempfile
import time
from pathlib import Path

from browser import WITH_WEBGL, hairlab, start_browser

WARM_UP, SECONDS = 4, 8
CASES = ((40, 11, 90), (2000, 30, 30), (2737, 39, 30), (2000, 30, 100))  # strands, points of each, frames


# Hair that hangs from a head and sways, as in motion.json.
def motion(strands, points, frames):
    chance = random.Random(1)
    low, high = (-0.2, -0.2, -0.3), (0.2, 0.2, 0.12)
    scale = [65535 / (b - a) for a, b in zip(low, high)]
    rest = []
    for _ in range(strands):
        z, angle = 0.1 * (0.2 + 0.8 * chance.random()), 2 * math.pi * chance.random()
        radius = math.sqrt(max(0, 0.01 - z * z))
        for i in range(points):
            t = i / (points - 1)
            out = 1 + 0.3 * math.sin(1.57 * t)
            rest.append((radius * math.cos(angle) * out + 0.006 * math.sin(20 * t + angle),
                         radius * math.sin(angle) * out, z * out - 0.25 * t ** 1.5, t))
    numbers = array.array("H")
    for frame in range(frames):
        phase = 2 * math.pi * frame / 30
        for x, y, z, t in rest:
            moved = (x + 0.03 * math.sin(phase + 3 * t) * t, y, z)
            numbers.extend(int((c - a) * s) for c, a, s in zip(moved, low, scale))
    return {"name": "sway", "shows": "hair that sways", "ended": "finished", "blow_up": None,
            "camera": {"eye": [0.3, -0.8, 0.1], "target": [0, 0, -0.05], "field_of_view": 0.6, "aspect": 16 / 9},
            "times": [k / 30 for k in range(frames)], "series": [{"name": "energy", "unit": "J", "values": [0.0] * frames}],
            "low": low, "high": high, "points": strands * points, "strands": [points] * strands, "strands_in_all": strands, "width": 1e-4,
            "root": [0.4, 0.3, 0.2], "tip": [0.6, 0.5, 0.3], "first_rod": strands * points, "rods": [], "sheets": [], "meshes": [], "planes": [],
            "data": base64.b64encode(numbers.tobytes()).decode()}


# ms between pictures of 800 x 450 pixels. It plays without an end.
PLAY = """
const [seconds, done] = arguments, picture = document.getElementById("picture"), times = [];
picture.style.cssText = "width: 800px; height: 450px; max-height: none; aspect-ratio: auto";
const { clock } = hairView;
const begin = performance.now(), look = (at) => {
  if (!clock.playing) clock.play();
  times.push(at);
  at < begin + 1000 * seconds ? requestAnimationFrame(look)
    : done(times.slice(1).map((time, i) => time - times[i]));
};
requestAnimationFrame(look);
"""


def cpu_seconds(root):
    children, total = [root], 0
    while children:
        process = children.pop()
        try:
            fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
            total += int(fields[11]) + int(fields[12])
            for task in Path(f"/proc/{process}/task").iterdir():
                children += (task / "children").read_text().split()
        except (FileNotFoundError, ProcessLookupError):
            pass
    return total / os.sysconf("SC_CLK_TCK")


def main():
    print(f"load {os.getloadavg()[0]:.1f}")
    print("| strands | points | frames | page, MB | opens, s | median, ms | a second | CPU ms a picture |\n|--:|--:|--:|--:|--:|--:|--:|--:|")
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "motion.json").write_text(json.dumps(motion(*case)), encoding="utf-8")
            Path(folder, "run.json").write_text('{"scene": "sway"}', encoding="utf-8")
            hairlab("view", folder)
            page = Path(folder, "view.html")
            driver = start_browser(WITH_WEBGL)
            begin = time.monotonic()
            driver.get(f"file://{page}")
            while not driver.execute_script("return window.hairView?.pictures > 0"):
                time.sleep(0.02)
            opens = time.monotonic() - begin
            driver.execute_async_script(PLAY, WARM_UP)
            cpu = cpu_seconds(driver.service.process.pid)
            waits = driver.execute_async_script(PLAY, SECONDS)
            cpu = cpu_seconds(driver.service.process.pid) - cpu
            median = statistics.median(waits)
            print(f"| {case[0]} | {case[1]} | {case[2]} | {page.stat().st_size / 1e6:.1f} | {opens:.1f} | {median:.1f} | {1000 / median:.1f} | {1000 * cpu / len(waits):.0f} |", flush=True)
            driver.quit()


if __name__ == "__main__":
    main()
