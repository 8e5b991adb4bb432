# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""figures_page_test.py works|faults PAGE [SCREENSHOTS]: tests of a page of `polylume figures`.

works: the page has no fault; with a folder SCREENSHOTS, pictures of it go there.
faults: broken twins of the page do have one each, of the kind that was put in.
"""

import pathlib
import re
import sys
import tempfile

import page_checker


def replace_once(text, old, new):
    changed = text.replace(old, new, 1)
    if changed == text:
        sys.exit(f"the page holds no {old!r}: the twin would not be broken")
    return changed


def without_image(text):
    """The first picture's data are cut short within the header."""
    return re.sub(r"(data:image/png;base64,.{20})[^\"]*", r"\1", text, count=1)


BROKEN_TWINS = {
    "a missing image": (without_image, "does not load"),
    "a slider that does not move":
        (lambda text: replace_once(text, 'slider.addEventListener("input", cut);', ""), "key"),
    "a slider that cuts nothing":
        (lambda text: replace_once(text, "clip-path:", "not-clip-path:"), "expected the left picture"),
    "a picture that is fetched":
        (lambda text: replace_once(text, "</main>",
                                   '<img alt="x" src="https://example.invalid/x.png"></main>'),
         "refers to https://example.invalid"),
    "an error in the script":
        (lambda text: replace_once(text, "<script>", "<script>null.x;"), "console"),
    "a table that is too wide":
        (lambda text: replace_once(text, "overflow-x: auto;", "min-width: 2000px;"), "px wide"),
}


def save_screenshots(browser, page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, size, dark in (("desktop", page_checker.DESKTOP, False),
                             ("desktop_dark", page_checker.DESKTOP, True),
                             ("phone", page_checker.PHONE, False)):
        page_checker.set_view(browser, size, dark)
        browser.get(page.resolve().as_uri())
        browser.execute_script(page_checker.IMAGES)
        page_checker.save_screenshot(browser, folder / f"{name}.png")


def test_works(browser, page, screenshots):
    faults = page_checker.check_page(browser, page)
    if screenshots:
        save_screenshots(browser, page, screenshots)
    return faults


def test_faults(browser, page):
    failures = []
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        for name, (break_page, expected) in BROKEN_TWINS.items():
            twin = pathlib.Path(folder) / "twin.html"
            twin.write_text(break_page(text), encoding="utf-8")
            faults = page_checker.check_page(browser, twin, (page_checker.DESKTOP,), 1)
            if not any(expected in fault for fault in faults):
                failures.append(f"{name}: expected a fault with {expected!r}, found {faults}")
    return failures


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[1] not in ("works", "faults"):
        sys.exit(__doc__)
    page = pathlib.Path(sys.argv[2])
    screenshots = pathlib.Path(sys.argv[3]) if len(sys.argv) == 4 else None
    browser = page_checker.open_browser()
    try:
        if sys.argv[1] == "works":
            faults = test_works(browser, page, screenshots)
        else:
            faults = test_faults(browser, page)
    finally:
        browser.quit()
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
