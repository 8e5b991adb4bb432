# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A display of its own, and polylume-view on it, driven by keys and mouse as a person would.

Needs Xvfb, xdotool, ImageMagick and xprop (Debian: xvfb xdotool imagemagick
x11-utils).
"""

import os
import re
import shlex
import shutil
import subprocess
import threading
import time

TOOLS = {"Xvfb": "xvfb", "xdotool": "xdotool", "import": "imagemagick", "convert": "imagemagick", "xprop": "x11-utils"}


class Failure(Exception):
    """What a test expected and found."""


def expect(condition, message):
    if not condition:
        raise Failure(message)


class Display:
    """An X server without a screen to look at."""

    def __init__(self, size=(1280, 800)):
        for tool, package in TOOLS.items():
            expect(shutil.which(tool), f"expected the program {tool}, found none; Debian: {package}")
        read, write = os.pipe()
        geometry = f"{size[0]}x{size[1]}x24"
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", geometry, "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as stream:
            number = stream.readline().strip()
        expect(number, "expected Xvfb to name a display, found that it ended")
        self.name = f":{number}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


class Viewer:
    """The program on a display. Its log is read while it runs; the log's lines are what tests go by."""

    def __init__(self, program, display, folder, arguments, environment=None):
        self.folder = folder
        self.environment = {**os.environ, "DISPLAY": display.name, "XDG_STATE_HOME": f"{folder}/state",
                            **(environment or {})}
        # A desktop that the tests are run in is not the display.
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.lines = []
        self.condition = threading.Condition()
        self.start = time.monotonic()
        self.process = subprocess.Popen([program, *arguments, "-v"], cwd=folder, env=self.environment,
                                        stderr=subprocess.PIPE, text=True)
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        for line in self.process.stderr:
            with self.condition:
                self.lines.append((time.monotonic(), line.rstrip("\n")))
                self.condition.notify_all()

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait()
        self.reader.join()
        if kind is not None:
            print(self.log())

    def log(self):
        return "\n".join(f"{when - self.start:8.3f} {line}" for when, line in self.lines)

    def mark(self):
        """A place in the log, to wait from."""
        with self.condition:
            return len(self.lines)

    def wait(self, pattern, since=0, seconds=150.0):
        """The match of the first line from `since` on that holds `pattern`, and when it came. `seconds` ends a hang: the
        reference works at low priority, and gets little of a machine that is busy."""
        end = time.monotonic() + seconds
        with self.condition:
            at = since
            while True:
                for when, line in self.lines[at:]:
                    match = re.search(pattern, line)
                    if match:
                        return match, when
                at = len(self.lines)
                left = end - time.monotonic()
                expect(left > 0, f'expected a line with "{pattern}" within {seconds} s, found none')
                expect(self.process.poll() is None or self.reader.is_alive(),
                       f'expected a line with "{pattern}", found that the program has ended')
                self.condition.wait(min(left, 0.5))

    def rest(self, since=0, seconds=150.0):
        """Waits for the picture to be complete: (width, height), EV, eye, index of the scene's camera or None."""
        match, _ = self.wait(r"at rest: (\d+)x(\d+), \d+ samples, EV (\S+), eye \((\S+), (\S+), (\S+)\)(?:, camera (\d+))?",
                             since, seconds)
        groups = match.groups()
        camera = None if groups[6] is None else int(groups[6])
        return (int(groups[0]), int(groups[1])), float(groups[2]), tuple(map(float, groups[3:6])), camera

    def xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def key(self, *keys):
        self.xdotool("key", *keys)

    def drag(self, start, end, button=1, steps=8):
        self.xdotool("mousemove", *start, "mousedown", button)
        for i in range(1, steps + 1):
            self.xdotool("mousemove", *(round(a + (b - a) * i / steps) for a, b in zip(start, end)))
            time.sleep(0.02)
        self.xdotool("mouseup", button)

    def click(self, place, button=1):
        self.xdotool("mousemove", *place, "click", button)

    def look(self, name, area=None):
        """What is on the display, or in the area (x, y, width, height) of it, as a PNG of this name."""
        path = f"{self.folder}/{name}"
        crop = ["-crop", "{2}x{3}+{0}+{1}".format(*area), "+repage"] if area else []
        subprocess.run(["import", "-window", "root", *crop, "-depth", "8", f"PNG24:{path}"], env=self.environment,
                       check=True)
        return path

    def screenshot(self, *keys):
        """Takes one by its key: the file's path and the command that the log says gives the same."""
        since = self.mark()
        self.key(*(keys or ["F12"]))
        match, _ = self.wait(r"Wrote (\S+\.(?:png|exr))$", since)
        name = match.group(1)
        self.wait(r"shown:", since)
        with self.condition:
            commands = [line for _, line in self.lines[since:] if line.startswith("polylume render ")]
        return f"{self.folder}/{name}", commands[0] if commands else None


def run_command(program, line, output, folder):
    """Runs a line of the log with the built command, to another file."""
    arguments = shlex.split(line)[1:]
    arguments[arguments.index("-o") + 1] = output
    subprocess.run([program, *arguments], cwd=folder, check=True, stderr=subprocess.DEVNULL)


def expect_same(program, found, wanted, limit=1.0001 / 255.0):
    """Two pictures of one size and kind that differ nowhere by more than `limit`."""
    result = subprocess.run([program, "compare", found, wanted, "--max-abs", str(limit)], capture_output=True,
                            text=True, check=False)
    expect(result.returncode == 0, f"expected {found} to be {wanted} within {limit}:\n{result.stdout}{result.stderr}")


def differ(program, found, wanted, limit=8.0 / 255.0):
    result = subprocess.run([program, "compare", found, wanted, "--max-abs", str(limit)], capture_output=True,
                            text=True, check=False)
    return result.returncode == 1
