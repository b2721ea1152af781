"""What the tests of the report share: a browser without a screen, and what a page may not do."""

import base64
import json
import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from program_case import ProgramCase, scene, skip_without  # noqa: E402,F401

CHROMIUM = shutil.which("chromium")
DRIVER = shutil.which("chromedriver")
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    webdriver = By = Keys = None

LARGE_MAP = os.environ["SAILMAP_LARGE_MAP"]
# A circuit driven three times: places 0 .. 11, then the same again.
LAPS = [place for _ in range(3) for place in range(12)]


def no_browser():
    return webdriver is None or CHROMIUM is None or DRIVER is None


needs_browser = skip_without(not no_browser(), "chromium, chromedriver or python3-selenium")


class ReportCase(ProgramCase):
    def run_laps(self, places=LAPS, folder="images"):
        self.write_sequence(places, folder)
        self.run_program("run", folder, "--map", "a.map", "--exclude-recent", "5")

    def browser(self, width=1280, height=900):
        options = Options()
        options.binary_location = CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         f"--window-size={width},{height}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        browser = webdriver.Chrome(options=options, service=Service(DRIVER))
        self.addCleanup(browser.quit)
        # Not the window's size: a window cannot be as narrow as a phone.
        browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False},
        )
        browser.set_script_timeout(60)
        return browser

    def open(self, browser, page="report.html"):
        browser.get((self.folder / page).as_uri())
        self.until(browser, lambda: browser.find_elements(By.CSS_SELECTOR, "#details table"))

    def until(self, browser, condition, seconds=60):
        return WebDriverWait(browser, seconds, poll_frequency=0.1).until(lambda _: condition())

    def all(self, browser, selector):
        return browser.find_elements(By.CSS_SELECTOR, selector)

    def one(self, browser, selector):
        return browser.find_element(By.CSS_SELECTOR, selector)

    def assert_quiet(self, browser):
        """Nothing on the console, and nothing asked of a network."""
        self.assertEqual([entry["message"] for entry in browser.get_log("browser")], [])
        asked = []
        for entry in browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                asked.append(message["params"]["request"]["url"])
        self.assertEqual([url[:60] for url in asked if not url.startswith(("data:", "file:"))], [])
        self.assertEqual(len([url for url in asked if url.startswith("file:")]), 1, asked)

    def canvas_bytes(self, browser, selector):
        """The canvas as it is, as a PNG."""
        uri = browser.execute_async_script(
            "const [selector, done] = arguments;"
            "requestAnimationFrame(() => requestAnimationFrame(() =>"
            " done(document.querySelector(selector).toDataURL())));",
            selector,
        )
        return base64.b64decode(uri.split(",", 1)[1])
