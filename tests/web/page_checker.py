# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Opens a page of `polylume figures` in headless Chromium and says what is wrong with it."""

import base64
import pathlib
import re
import sys

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.actions.action_builder import ActionBuilder
    from selenium.webdriver.common.actions.pointer_input import PointerInput
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError as error:
    sys.exit(f"expected Selenium for Python ({error}); install the Debian package python3-selenium")

DESKTOP = (1280, 800)
PHONE = (400, 800)

# How many of 101 points across the pair show the left picture: points that are cut off by
# clip-path are not hit.
LEFT_SHARE = """
const over = arguments[0].querySelector(".over");
const box = arguments[0].getBoundingClientRect();
let count = 0;
for (let i = 0; i <= 100; ++i) {
    const x = box.left + 0.5 + (box.width - 1) * i / 100;
    if (document.elementsFromPoint(x, box.top + box.height / 2).includes(over)) ++count;
}
return count;
"""

IMAGES = """
return Promise.all([...document.images].map(async image => {
    try { await image.decode(); } catch (error) { return image.alt || "without a text"; }
    return image.naturalWidth > 0 && image.alt ? "" : image.alt || "without a text";
}));
"""


def find_program(name, package):
    path = pathlib.Path("/usr/bin") / name
    if not path.exists():
        sys.exit(f"expected {path}; install the Debian package {package}")
    return str(path)


def open_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = find_program("chromium", "chromium")
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                 "--disable-dev-shm-usage", "--force-device-scale-factor=1",
                 "--disable-background-networking", "--disable-component-update"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = Service(find_program("chromedriver", "chromium-driver"))
    try:
        return webdriver.Chrome(service=service, options=options)
    except WebDriverException as error:
        sys.exit(f"Chromium does not start; are chromium and chromium-driver of one version? {error}")


def set_view(browser, size, dark=False):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": size[0], "height": size[1], "deviceScaleFactor": 1,
                             "mobile": False})
    scheme = "dark" if dark else "light"
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": scheme}]})


def save_screenshot(browser, path, whole=True):
    metrics = browser.execute_script(
        "return [document.documentElement.clientWidth, document.documentElement.scrollHeight]")
    options = {"format": "png", "captureBeyondViewport": whole}
    if whole:
        options["clip"] = {"x": 0, "y": 0, "width": metrics[0], "height": metrics[1], "scale": 1}
    data = browser.execute_cdp_cmd("Page.captureScreenshot", options)["data"]
    pathlib.Path(path).write_bytes(base64.b64decode(data))


def left_share(browser, pair):
    browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", pair)
    return browser.execute_script(LEFT_SHARE, pair)


def drag(browser, pair, kind):
    """Presses in the middle and moves to a quarter from the left."""
    width = pair.size["width"]
    if kind == "mouse":
        chain = ActionChains(browser)
        chain.move_to_element(pair).click_and_hold().move_by_offset(-int(width / 4), 0)
        chain.release().perform()
        return
    actions = ActionBuilder(browser, mouse=PointerInput("touch", "finger"))
    finger = actions.pointer_action
    finger.move_to(pair).pointer_down().move_to(pair, -int(width / 4), 0).pointer_up()
    actions.perform()


def check_slider(browser, pair, name):
    slider = pair.find_element(By.CSS_SELECTOR, "input[type=range]")
    faults = []
    if not slider.get_attribute("aria-label"):
        faults.append(f"{name}: the slider has no name")
    start = left_share(browser, pair)
    if abs(start - 50) > 3:
        faults.append(f"{name}: expected the left picture on half of the pair, found {start} %")
    slider.send_keys(Keys.END)
    end = left_share(browser, pair)
    if end < 98:
        faults.append(f"{name}: the End key leaves the left picture on {end} %")
    slider.send_keys(Keys.HOME)
    home = left_share(browser, pair)
    if home > 2:
        faults.append(f"{name}: the Home key leaves the left picture on {home} %")
    slider.send_keys(Keys.ARROW_RIGHT * 5)
    if left_share(browser, pair) <= home:
        faults.append(f"{name}: the arrow keys do not move the slider")
    for kind in ("mouse", "touch"):
        slider.send_keys(Keys.END)
        left_share(browser, pair)  # Scrolls it into view.
        drag(browser, pair, kind)
        found = left_share(browser, pair)
        if abs(found - 25) > 4:
            faults.append(f"{name}: dragged by {kind} to a quarter, it shows {found} %")
    return faults


def check_network(browser, text):
    faults = [f"refers to {match}" for match in re.findall(r"(?i)\b(?:https?|ftp)://[^\s\"'<>]*", text)]
    faults += [f"refers to {match}" for match in re.findall(r"(?:src|href)=\"(?!data:|#)[^\"]*\"", text)]
    fetched = browser.execute_script(
        "return performance.getEntriesByType('resource').map(entry => entry.name)")
    return faults + [f"fetched {name[:80]}" for name in fetched if not name.startswith("data:")]


def check_page(browser, page, sizes=(DESKTOP, PHONE), most_pairs=None):
    """What is wrong with the page, one line each; empty where all is well. Only the sliders of the
    first `most_pairs` pairs are tried."""
    browser.get_log("browser")  # What earlier pages left.
    faults = []
    for size in sizes:
        set_view(browser, size)
        browser.get(pathlib.Path(page).resolve().as_uri())
        where = f"at {size[0]} px"
        bad = [alt for alt in browser.execute_script(IMAGES) if alt]
        faults += [f"{where}: an image does not load: {alt}" for alt in bad]
        wide = browser.execute_script("return document.documentElement.scrollWidth")
        if wide > size[0]:
            faults.append(f"{where}: the page is {wide} px wide")
        pairs = browser.find_elements(By.CSS_SELECTOR, ".pair")
        if not pairs:
            faults.append(f"{where}: found no pair of pictures")
        for index, pair in enumerate(pairs[:most_pairs]):
            faults += check_slider(browser, pair, f"{where}, pair {index + 1}")
    faults += check_network(browser, pathlib.Path(page).read_text(encoding="utf-8"))
    faults += [f"console: {entry['message']}" for entry in browser.get_log("browser")
               if entry["level"] in ("SEVERE", "WARNING")]
    return faults
