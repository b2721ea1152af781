"""sailmap report: what is on the page, and what it says to wrong input."""

import json
import re
import subprocess
import unittest

import cv2
import numpy as np
from report_case import LAPS, LARGE_MAP, By, Keys, ReportCase, needs_browser, scene


def data_of(path):
    text = path.read_text()
    found = re.findall(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)
    assert len(found) == 1
    return json.loads(found[0])


class ReportPage(ReportCase):
    def report(self, *arguments, source="a.map"):
        self.run_program("report", source, "-o", "report.html", *arguments)
        return data_of(self.folder / "report.html")

    def write_truth(self):
        lines = [f"{q}: " + " ".join(str(c) for c in range(q % 12, q, 12)) for q in range(12, len(LAPS))]
        (self.folder / "truth.txt").write_text("\n".join(lines) + "\n")

    def test_data_agrees_with_what_the_run_said(self):
        self.write_sequence(LAPS)
        lines = self.run_program("run", "images", "--map", "a.map", "--exclude-recent", "5", "--json").splitlines()
        events = [json.loads(line) for line in lines]
        loops = [e for e in events if e["event"] == "loop_closure"]
        data = self.report()
        self.assertGreaterEqual(len(loops), 20)
        self.assertEqual(data["loops"]["image"], [e["image"] for e in loops])
        for score, event in zip(data["loops"]["score"], loops):
            self.assertAlmostEqual(score / event["best"]["similarity"], 1, places=4)
        self.assertEqual(data["graph"]["nodes"], events[-1]["nodes"])
        self.assertEqual(data["images"]["count"], len(LAPS))

    def test_matched_regions_are_those_of_the_two_files(self):
        """The boxes on the page against those that `detect` finds in the same files."""
        self.run_laps()
        data = self.report()
        pair = data["pairs"][0]
        image = data["loops"]["image"][pair["loop"]]
        self.run_program("detect", f"images/{image}.png", "--out", "seen")
        regions = self.json("seen/regions.json")["regions"]
        boxes = np.array(pair["regions"]).reshape(-1, 4)
        self.assertGreater(len(pair["matches"]), 0)
        self.assertEqual(len(boxes), len(regions))
        for box, region in zip(boxes, regions):
            self.assertTrue(box[0] <= region["x"] <= box[0] + box[2])
            self.assertTrue(box[1] <= region["y"] <= box[1] + box[3])

    def test_precision_and_recall_against_ground_truth_by_hand(self):
        self.run_laps()
        self.write_truth()
        data = self.report("--ground-truth", "truth.txt")
        # Places are 12 apart: a loop is right when both images show the same one.
        right = [i % 12 == p % 12 for i, p in zip(data["loops"]["image"], data["loops"]["place"])]
        self.assertEqual(data["loops"]["right"], right)
        fixed = data["evaluation"]["fixed"]
        self.assertEqual((fixed["detections"], fixed["right"]), (len(right), sum(right)))
        self.assertAlmostEqual(fixed["precision"], sum(right) / len(right), places=5)
        self.assertAlmostEqual(fixed["recall"], sum(right) / 24, places=5)

    def test_evaluation_file(self):
        self.write_sequence(LAPS)
        self.write_truth()
        self.run_program(
            "eval", "images", "--ground-truth", "truth.txt", "--exclude-recent", "5", "--json", "e.json",
            "--scores", "s.npy")
        evaluation = self.json("e.json")
        data = self.report(source="e.json")
        scores = np.load(self.folder / "s.npy")
        for query, image in zip(evaluation["best"]["candidate"], range(len(LAPS))):
            if query is not None:
                self.assertEqual(query, int(np.nanargmax(scores[image])))
        above = [q for q in range(len(LAPS)) if np.nanmax(np.append(scores[q], -1)) > evaluation["fixed_threshold"]["threshold"]]
        self.assertEqual(data["loops"]["image"], above)
        self.assertEqual(len(data["loops"]["image"]), evaluation["fixed_threshold"]["detections"])
        self.assertGreater(len(data["pairs"][0]["matches"]), 0)
        self.assertEqual(data["evaluation"]["average_precision"], evaluation["average_precision"])

    def test_limits(self):
        self.run_laps()
        few = self.report("--pairs", "4", "--thumbnails", "0")
        self.assertEqual(len(few["pairs"]), 4)
        self.assertEqual({p["why"] for p in few["pairs"]}, {"strongest", "weakest", "doubtful"})
        self.assertLessEqual(len(few["pictures"]), 12)
        chosen = self.report("--pairs", "0", "--thumbnails", "0", "--image", "3", "--image", "30")
        self.assertEqual(sorted(chosen["pictures"]), ["3", "30"])
        self.assertEqual(len(chosen["pictures"]["3"]["saliency"]), 4)
        tight = self.report("--budget", "0.1")
        size = sum(len(json.dumps(p)) for p in tight["pictures"].values())
        self.assertLess(size, 200_000)
        self.assertIn("--budget", " ".join(tight["problems"]))

    def test_missing_images_are_told_on_the_page(self):
        self.run_laps()
        (self.folder / "images/30.png").unlink()
        (self.folder / "images").rename(self.folder / "elsewhere")
        gone = self.report()
        self.assertIn("could not be read", " ".join(gone["problems"]))
        self.assertEqual(gone["pictures"], {})
        moved = self.report("--image-root", "elsewhere")
        self.assertIn("1 image could not be read", " ".join(moved["problems"]))
        self.assertGreater(len(moved["pictures"]), 20)

    def test_thumbnails_of_the_map_stand_in(self):
        self.write_sequence(LAPS)
        self.run_program("run", "images", "--map", "a.map", "--exclude-recent", "5", "--thumbnails", "80")
        (self.folder / "images").rename(self.folder / "elsewhere")
        data = self.report()
        self.assertGreater(len(data["pictures"]), 20)
        self.assertGreater(len(data["pairs"][0]["matches"]), 0)

    def test_wrong_input(self):
        self.run_laps()
        self.write_truth()
        (self.folder / "cut.json").write_text('{"source": "x", "curve": [')
        (self.folder / "other.json").write_text('{"a": 1}')
        (self.folder / "few.csv").write_text("x,y\n1,2\n")
        self.fails("report", "none.map", "-o", "r.html", says="none.map")
        self.fails("report", "cut.json", "-o", "r.html", says="cut.json")
        self.fails("report", "other.json", "-o", "r.html", says="other.json")
        self.fails("report", "a.map", "-o", "no/such/r.html", says="no/such/r.html")
        self.fails("report", "a.map", "-o", "r.html", "--poses", "few.csv", says="36")
        self.fails("report", "a.map", "-o", "r.html", "--image", "99", says="99")
        self.fails("report", "truth.txt", "-o", "r.html", says="truth.txt")


@needs_browser
class ReportInBrowser(ReportCase):
    def prepare(self, *arguments):
        self.run_laps()
        self.run_program("report", "a.map", "-o", "report.html", *arguments)

    def pair_title(self, browser):
        return self.one(browser, ".pair h3").text

    def test_click_a_loop_and_see_its_pair(self):
        self.prepare()
        browser = self.browser()
        self.open(browser)
        rows = self.all(browser, ".loop")
        self.assertGreater(len(rows), 5)
        for row in (rows[3], rows[1]):
            wanted = row.find_element(By.CSS_SELECTOR, ".who").text.split("\n")[0]
            browser.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", row)
            row.click()
            image, place = wanted.replace("image ", "").split(" → ")
            self.assertTrue(self.pair_title(browser).startswith(f"Image {image} → image {place}"))
            self.assertEqual(row.get_attribute("aria-selected"), "true")
            figure = self.one(browser, ".pair svg.figure")
            self.assertEqual(len(figure.find_elements(By.CSS_SELECTOR, "image")), 2)
            self.assertGreater(len(figure.find_elements(By.CSS_SELECTOR, "line")), 0)
        self.assert_quiet(browser)

    def test_keyboard(self):
        self.prepare()
        browser = self.browser()
        self.open(browser)
        loops = self.all(browser, ".loop")
        browser.execute_script("document.querySelector('.list').focus()")
        active = browser.switch_to.active_element
        active.send_keys(Keys.HOME)
        first = self.pair_title(browser)
        active.send_keys(Keys.ARROW_DOWN)
        second = self.pair_title(browser)
        self.assertNotEqual(first, second)
        active.send_keys(Keys.ARROW_UP)
        self.assertEqual(self.pair_title(browser), first)
        chosen = active.get_attribute("aria-activedescendant")
        self.assertEqual(self.one(browser, f"#{chosen}").get_attribute("aria-selected"), "true")
        # The focus shows, and Tab leaves the list for what is after it.
        outline = browser.execute_script("return getComputedStyle(document.activeElement).outlineStyle")
        self.assertNotEqual(outline, "none")
        active.send_keys(Keys.TAB)
        self.assertNotEqual(browser.switch_to.active_element, active)
        # The map: zoomed and moved by keys.
        browser.execute_script("document.querySelector('canvas.graph').focus()")
        before = self.canvas_bytes(browser, "canvas.graph")
        browser.switch_to.active_element.send_keys("+")
        zoomed = self.canvas_bytes(browser, "canvas.graph")
        self.assertNotEqual(before, zoomed)
        browser.switch_to.active_element.send_keys(Keys.ARROW_LEFT)
        self.assertNotEqual(zoomed, self.canvas_bytes(browser, "canvas.graph"))
        browser.switch_to.active_element.send_keys("0")
        self.assertEqual(before, self.canvas_bytes(browser, "canvas.graph"))
        self.assertGreater(len(loops), 0)
        self.assert_quiet(browser)

    def test_a_narrow_screen(self):
        self.prepare("--title", "a_title_without_a_place_to_break_" * 6)
        for width in (360, 1280):
            browser = self.browser(width=width, height=740)
            self.open(browser)
            size = browser.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
            self.assertLessEqual(size[0], size[1])
            self.assertEqual(size[1], width)

    def test_names_are_text(self):
        nasty = "<img src=x onerror=alert(1)>&amp;</script><script>alert(2)<!--.png"
        nasty = nasty.replace("/", "\\u2215".encode().decode("unicode_escape"))
        for k, place in enumerate(LAPS):
            self.write_image(f"images/{k:02}{nasty}", scene(place))
        self.run_program("run", "images", "--map", "a.map", "--exclude-recent", "5")
        title = "</script><script>alert(3)</script><b>%SCRIPT% %DATA%"
        self.run_program("report", "a.map", "-o", "report.html", "--title", title)
        browser = self.browser()
        self.open(browser)
        self.assertEqual(self.one(browser, "h1").text, title)
        self.assertIn(nasty, self.one(browser, ".loop small").get_attribute("textContent"))
        self.assertEqual(self.all(browser, ".loop img, h1 b, img[src=x]"), [])
        self.assert_quiet(browser)

    def test_matrix_curve_and_saliency(self):
        lines = [f"{q}: " + " ".join(str(c) for c in range(q % 12, q, 12)) for q in range(12, len(LAPS))]
        (self.folder / "truth.txt").write_text("\n".join(lines) + "\n")
        self.prepare("--ground-truth", "truth.txt")
        browser = self.browser()
        self.open(browser)
        browser.execute_script("document.querySelector('canvas.matrix').focus()")
        browser.switch_to.active_element.send_keys(Keys.ARROW_DOWN, Keys.ARROW_RIGHT)
        self.assertIn("similarity", self.one(browser, "#similarity .readout").text.lower())
        browser.execute_script("document.querySelector('svg.chart').focus()")
        browser.switch_to.active_element.send_keys(Keys.ARROW_RIGHT)
        self.assertRegex(self.one(browser, "#precision .readout").text, r"Threshold .* precision 100 %")
        thumbs = self.all(browser, ".strip button")
        browser.execute_script("arguments[0].scrollIntoView({block: 'center'}); arguments[0].click()", thumbs[2])
        self.assertEqual(thumbs[2].get_attribute("aria-selected"), "true")
        self.assertEqual(len(self.all(browser, "#saliency .maps img")), 4)
        shown = browser.execute_script(
            "return [...document.querySelectorAll('#saliency img')].every((i) => i.naturalWidth > 0)")
        self.assertTrue(shown)
        self.assert_quiet(browser)

    def test_twenty_thousand_places(self):
        subprocess.run([LARGE_MAP, "large.map", "20000"], cwd=self.folder, check=True)
        self.run_program("report", "large.map", "-o", "report.html")
        self.assertLess((self.folder / "report.html").stat().st_size, 8_000_000)
        browser = self.browser()
        self.open(browser)
        self.assertIn("20,000", self.one(browser, ".lead").text)
        whole = self.canvas_bytes(browser, "canvas.graph")
        self.assertGreater(len(np.unique(self.decode(whole).reshape(-1, 3), axis=0)), 20)
        browser.execute_script("document.querySelector('canvas.graph').focus()")
        for _ in range(6):
            browser.switch_to.active_element.send_keys("+")
        zoomed = self.canvas_bytes(browser, "canvas.graph")
        self.assertNotEqual(whole, zoomed)
        # All loops are in the list, a few as elements.
        self.assertLess(len(self.all(browser, ".loop")), 80)
        browser.execute_script("document.querySelector('.list').focus()")
        browser.switch_to.active_element.send_keys(Keys.END)
        last = self.all(browser, ".loop")[-1]
        self.assertEqual(last.get_attribute("aria-posinset"), last.get_attribute("aria-setsize"))
        self.assertEqual(last.get_attribute("aria-setsize"), "20000")
        self.assert_quiet(browser)

    def decode(self, png):
        return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR)


if __name__ == "__main__":
    unittest.main()
