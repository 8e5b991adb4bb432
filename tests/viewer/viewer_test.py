# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Drives polylume-view in a real window: viewer_test.py CASE BUILD_DIR SOURCE_DIR WORK_DIR."""

import math
import os
import shutil
import subprocess
import sys
import time

from viewer_driver import Display, Failure, Viewer, differ, expect, expect_same, run_command

WINDOW = (640, 480)
PANEL = 330  # Its width at 96 dots an inch.


class Case:
    def __init__(self, build, source, folder):
        self.build = build
        self.viewer_program = f"{build}/polylume-view"
        self.program = f"{build}/polylume"
        self.source = source
        self.folder = folder

    def sample(self, name):
        return f"{self.source}/samples/scenes/{name}"

    def open(self, display, *arguments, environment=None):
        size = f"{WINDOW[0]}x{WINDOW[1]}"
        return Viewer(self.viewer_program, display, self.folder, [*arguments, "--size", size, "--samples", "4"],
                      environment)

    def whole(self, viewer):
        """Puts the panel away, so that the picture fills the window."""
        viewer.rest()
        since = viewer.mark()
        viewer.key("Tab")
        size, _, eye, camera = viewer.rest(since)
        expect(size == WINDOW, f"expected the picture to fill {WINDOW}, found {size}")
        time.sleep(0.3)
        return eye, camera

    # What the window shows, what a screenshot holds and what the command renders is one picture.
    def shows_what_render_renders(self):
        with Display() as display, self.open(display, self.sample("studio.glb"), "--quality", "high") as viewer:
            self.whole(viewer)
            seen = viewer.look("seen.png", (0, 0, *WINDOW))
            shot, command = viewer.screenshot()
            expect(command, "expected the command that renders the same picture in the log, found none")
            run_command(self.program, command, "rendered.png", self.folder)
            expect_same(self.program, shot, f"{self.folder}/rendered.png")
            expect_same(self.program, seen, shot)
            # Of all tone maps; EXR holds the radiance itself.
            for name in ["neutral", "none", "reinhard"]:
                since = viewer.mark()
                viewer.key("t")
                viewer.wait("shown: t", since)
                time.sleep(0.3)
                shot, command = viewer.screenshot()
                expect(name in command, f"expected --tonemap {name} in {command}")
                run_command(self.program, command, "rendered.png", self.folder)
                expect_same(self.program, shot, f"{self.folder}/rendered.png")
                os.remove(shot)
            shot, command = viewer.screenshot("shift+F12")
            run_command(self.program, command, "rendered.exr", self.folder)
            expect_same(self.program, shot, f"{self.folder}/rendered.exr", 0.0)

    def camera_follows_the_mouse(self):
        middle = (WINDOW[0] // 2, WINDOW[1] // 2)
        with Display() as display, self.open(display, self.sample("cornell.glb")) as viewer:
            start, camera = self.whole(viewer)
            expect(camera == 0, f"expected the scene's first camera, found {camera}")
            before = viewer.look("before.png", (0, 0, *WINDOW))

            def moves(what, action, distance):
                since = viewer.mark()
                action()
                _, _, eye, moved = viewer.rest(since)
                expect(moved is None, f"expected {what} to leave the scene's camera")
                expect(math.dist(eye, start) > distance, f"expected {what} to move the eye from {start}, found {eye}")
                viewer.look(f"{what}.png", (0, 0, *WINDOW))
                since = viewer.mark()
                viewer.key("Home")
                _, _, eye, moved = viewer.rest(since)
                expect(moved == 0 and math.dist(eye, start) < 1e-4, f"expected Home to return to {start}, found {eye}")

            moves("orbit", lambda: viewer.drag(middle, (middle[0] + 120, middle[1] - 40)), 0.05)
            moves("pan", lambda: viewer.drag(middle, (middle[0] + 90, middle[1]), button=2), 0.05)
            moves("dolly", lambda: viewer.xdotool("mousemove", *middle, "click", 4, "click", 4), 0.05)

            def fly():
                viewer.xdotool("mousemove", *middle, "mousedown", 3, "keydown", "w")
                time.sleep(0.6)
                viewer.xdotool("keyup", "w", "mouseup", 3)

            moves("fly", fly, 0.02)
            viewer.key("f")
            time.sleep(1.5)
            since = viewer.mark()
            viewer.key("Home")
            viewer.rest(since)
            time.sleep(0.3)
            # To the last bit, not nearly.
            expect_same(self.program, viewer.look("after.png", (0, 0, *WINDOW)), before, 0.0)

    def keys_show_and_hide(self):
        with Display() as display, self.open(display, self.sample("cornell.glb")) as viewer:
            self.whole(viewer)
            plain = viewer.look("plain.png", (0, 0, *WINDOW))

            def toggles(key, name, until=None):
                since = viewer.mark()
                viewer.key(key)
                viewer.wait("shown:", since)
                if until:
                    viewer.wait(until, since)
                time.sleep(0.6)
                shown = viewer.look(f"{name}.png", (0, 0, *WINDOW))
                expect(differ(self.program, shown, plain), f"expected {key} to change what is seen")
                since = viewer.mark()
                viewer.key(key)
                viewer.wait("shown:", since)
                time.sleep(0.6)
                expect_same(self.program, viewer.look("again.png", (0, 0, *WINDOW)), plain, 0.0)

            toggles("F1", "help")
            toggles("r", "split", "reference: 64 paths")
            toggles("e", "error", "reference: 64 paths")
            since = viewer.mark()
            viewer.key("h")
            viewer.rest(since)
            time.sleep(0.3)
            expect(differ(self.program, viewer.look("hidden.png", (0, 0, *WINDOW)), plain), "expected H to hide lights")
            since = viewer.mark()
            viewer.key("Tab")
            size, *_ = viewer.rest(since)
            expect(size == (WINDOW[0] - PANEL, WINDOW[1]), f"expected the panel to take {PANEL}, found {size}")

    def files_are_read_again(self):
        scene = f"{self.folder}/scene.glb"
        shaders = f"{self.folder}/glsl"
        shutil.copy(self.sample("cornell.glb"), scene)
        shutil.copytree(f"{self.source}/glsl", shaders)
        with Display() as display, self.open(display, scene, "--glsl-dir", shaders) as viewer:
            self.whole(viewer)
            first = viewer.look("first.png", (0, 0, *WINDOW))

            def replace(path, content):
                since = viewer.mark()
                with open(path + ".new", "wb") as stream:
                    stream.write(content)
                os.replace(path + ".new", path)
                return since

            with open(self.sample("studio.glb"), "rb") as stream:
                since = replace(scene, stream.read())
            viewer.wait("opened scene.glb: 61264 triangles", since)
            viewer.rest(since)
            time.sleep(0.3)
            second = viewer.look("second.png", (0, 0, *WINDOW))
            expect(differ(self.program, second, first), "expected another picture of another scene")

            since = replace(scene, b"this is no glTF")
            viewer.wait("scene.glb", since)
            time.sleep(0.5)
            broken = viewer.look("broken.png", (0, 0, *WINDOW))
            # The message stands above; the last good picture below it.
            lower = (0, WINDOW[1] // 2, WINDOW[0], WINDOW[1] // 4)
            shutil.copy(broken, f"{self.folder}/kept.png")
            for name in ["second", "broken"]:
                subprocess.run(["convert", f"{self.folder}/{name}.png", "-crop",
                                "{2}x{3}+{0}+{1}".format(*lower), "+repage", f"PNG24:{self.folder}/{name}_part.png"],
                               check=True)
            expect_same(self.program, f"{self.folder}/broken_part.png", f"{self.folder}/second_part.png", 0.0)
            expect(differ(self.program, broken, second), "expected an error to be shown")

            with open(self.sample("cornell.glb"), "rb") as stream:
                since = replace(scene, stream.read())
            viewer.rest(since)
            viewer.wait("Read scene.glb again", since)

            path = f"{shaders}/passes/display.frag"
            with open(path, "rb") as stream:
                source = stream.read()
            last = b"outColor = vec4(color, 1.0);"
            since = replace(path, source.replace(last, last[:-1]))
            viewer.wait(r"warning: .*|passes/display\.frag:", since)
            time.sleep(0.5)
            viewer.look("broken_shader.png")
            expect(viewer.process.poll() is None, "expected the window to live on with a broken shader")
            since = replace(path, source.replace(last, b"outColor = vec4(color.bgr, 1.0);"))
            viewer.wait("Read the shaders again", since)
            viewer.rest(since)
            time.sleep(0.3)
            # Red and blue are exchanged, away from the messages.
            def part(name):
                upper = "{2}x{3}+{0}+{1}".format(0, WINDOW[1] // 4, WINDOW[0], WINDOW[1] // 2)
                swap = ["-color-matrix", "0 0 1 0 1 0 1 0 0"] if name == "first" else []
                subprocess.run(["convert", f"{self.folder}/{name}.png", *swap, "-crop", upper, "+repage", "-depth",
                                "8", f"PNG24:{self.folder}/{name}_part.png"], check=True)
                return f"{self.folder}/{name}_part.png"

            viewer.look("shader.png", (0, 0, *WINDOW))
            expect_same(self.program, part("shader"), part("first"), 0.0)

    # What is saved renders to what is seen.
    def saved_scenes_render_alike(self):
        scene = f"{self.folder}/scene.glb"
        shutil.copy(self.sample("gallery.glb"), scene)
        with Display() as display, self.open(display, scene) as viewer:
            self.whole(viewer)
            since = viewer.mark()
            viewer.drag((300, 240), (380, 220))
            viewer.rest(since)
            since = viewer.mark()
            viewer.key("ctrl+s")
            viewer.wait(r"Wrote .*scene_edited\.glb", since)
            viewer.wait("shown:", since)
            with viewer.condition:
                command = [line for _, line in viewer.lines[since:] if line.startswith("polylume render ")][0]
            shot, again = viewer.screenshot()
            expect(again and "scene_edited.glb" in again, f"expected the saved scene's command, found {again}")
            run_command(self.program, command, "rendered.png", self.folder)
            expect_same(self.program, shot, f"{self.folder}/rendered.png")
            # A view that was moved since is not what was saved.
            since = viewer.mark()
            viewer.drag((300, 240), (380, 220))
            viewer.rest(since)
            _, again = viewer.screenshot()
            expect(again is None, f"expected to be told to save first, found {again}")

    def errors_end_it(self):
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("DISPLAY", "WAYLAND_DISPLAY")}

        def run(*command):
            return subprocess.run(command, env=environment, capture_output=True, text=True, cwd=self.folder,
                                  check=False)

        result = run(self.program, "view", self.sample("cornell.glb"))
        expect(result.returncode == 1 and "polylume view: error: no display" in result.stderr,
               f"expected 1 and a message, found {result.returncode}: {result.stderr}")
        result = run(self.program, "view", "--no-such-flag")
        expect(result.returncode == 2, f"expected 2, found {result.returncode}")
        result = run(self.program, "view", "--help")
        expect(result.returncode == 0 and "SCENE" in result.stdout, f"expected help, found {result.returncode}")
        lonely = f"{self.folder}/bin"
        os.mkdir(lonely)
        shutil.copy(self.program, lonely)
        result = run(f"{lonely}/polylume", "view", self.sample("cornell.glb"))
        expect(result.returncode == 1 and "libglfw3-dev" in result.stderr,
               f"expected 1 and what to install, found {result.returncode}: {result.stderr}")

    def scenes_can_be_dropped(self):
        with Display() as display, self.open(display) as viewer:
            viewer.wait("window: after")
            time.sleep(0.5)
            viewer.look("empty.png")
            since = viewer.mark()
            path = self.sample("cornell.glb")
            result = subprocess.run([f"{self.build}/drop_file", path], env=viewer.environment, capture_output=True,
                                    text=True, check=False)
            expect(result.returncode == 0, f"expected the window to take a drop, found {result.stderr}")
            viewer.wait("opened cornell.glb", since)
            _, _, _, camera = viewer.rest(since)
            expect(camera == 0, f"expected the dropped scene's camera, found {camera}")
            since = viewer.mark()
            subprocess.run([f"{self.build}/drop_file", self.sample("gallery.glb")], env=viewer.environment, check=True)
            viewer.wait("opened gallery.glb", since)
            viewer.rest(since)

    # Size and scene of the last window; and nothing is done while nothing happens.
    def it_remembers_and_rests(self):
        with Display() as display:
            with self.open(display, self.sample("cornell.glb")) as viewer:
                viewer.rest()
                time.sleep(1.0)
                before = self.cpu_seconds(viewer)
                time.sleep(3.0)
                used = self.cpu_seconds(viewer) - before
                print(f"seconds of processor in 3 s of rest: {used:.2f}")
                expect(used < 0.3, f"expected a window at rest to leave the processor, found {used:.2f} s in 3 s")
            with Viewer(self.viewer_program, display, self.folder, []) as viewer:
                viewer.wait("opened cornell.glb")
                size, *_ = viewer.rest()
                expect(size == (WINDOW[0] - PANEL, WINDOW[1]), f"expected the last window's size, found {size}")

    @staticmethod
    def cpu_seconds(viewer):
        with open(f"/proc/{viewer.process.pid}/stat", encoding="utf-8") as stream:
            fields = stream.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    # On a screen of many dots an inch the panel is larger, and what it leaves is the picture.
    def it_is_larger_on_fine_screens(self):
        with Display() as display:
            environment = {**os.environ, "DISPLAY": display.name}
            subprocess.run(["xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER",
                            "Xft.dpi:\t192\n"], env=environment, check=True)
            arguments = [self.sample("cornell.glb"), "--size", "1200x700", "--samples", "1"]
            with Viewer(self.viewer_program, display, self.folder, arguments) as viewer:
                size, *_ = viewer.rest()
                expect(size == (1200 - 2 * PANEL, 700), f"expected a panel of twice {PANEL}, found {size}")
                viewer.look("fine.png")

    # A scene that can't be read leaves an empty window with a message.
    def bad_scenes_are_told(self):
        with Display() as display, self.open(display, f"{self.folder}/missing.glb") as viewer:
            viewer.wait("missing.glb")
            time.sleep(0.7)
            expect(viewer.process.poll() is None, "expected the window to stay")
            viewer.look("missing.png")

    def measure_latency(self, scene):
        """Milliseconds from a key's press to the frame that shows it, while the reference refines."""
        times = []
        with Display() as display, Viewer(self.viewer_program, display, self.folder,
                                          [scene, "--size", "1280x720"]) as viewer:
            viewer.rest()
            since = viewer.mark()
            viewer.key("r")
            viewer.wait(r"reference: \d+ paths", since, 60)
            for key in ["e", "r", "bracketright", "t", "F1"] * 4:
                time.sleep(0.3)
                since = viewer.mark()
                begin = time.monotonic()
                viewer.key(key)
                _, when = viewer.wait("shown:", since)
                times.append(1e3 * (when - begin))
                if key == "r":
                    viewer.wait(r"reference: \d+ paths", since, 60)
        return sorted(times)

    # Loosely: other work may run on the machine. The figures are printed.
    def keys_act_while_the_reference_refines(self):
        times = self.measure_latency(self.sample("studio.glb"))
        print("milliseconds:", " ".join(f"{time:.0f}" for time in times))
        expect(times[len(times) // 2] < 400, f"expected a median below 400 ms, found {times[len(times) // 2]:.0f}")

    def the_first_picture_comes_soon(self):
        assets = os.environ.get("POLYLUME_ASSETS")
        scene = f"{assets}/FlightHelmet/FlightHelmet.gltf" if assets else self.sample("studio.glb")
        with Display() as display, Viewer(self.viewer_program, display, self.folder,
                                          [scene, "--size", "1280x720"]) as viewer:
            match, _ = viewer.wait(r"first picture: after (\d+) ms", 0, 60)
            print(f"milliseconds: {match.group(1)} ({scene})")
            expect(int(match.group(1)) < 6000, f"expected a picture within 6 s, found {match.group(1)} ms")
            viewer.rest()


def main():
    name, build, source, work = sys.argv[1:]
    folder = f"{work}/{name}"
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    try:
        getattr(Case(build, source, folder), name)()
    except Failure as failure:
        print(f"failed: {failure}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
