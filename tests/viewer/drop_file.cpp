// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Drops a file on the first window that takes drops, as a file manager would: drop_file PATH. The
// protocol is XDND (freedesktop.org, version 5). Exits 0 when the window has taken the file.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace {

constexpr long kVersion = 5;
constexpr int kPatienceMilliseconds = 10'000;

struct Source {
    Display* display = nullptr;
    Window window = 0;
    Window target = 0;
    std::string uris;

    Atom atom(const char* name) const { return XInternAtom(display, name, False); }

    void send(const char* type, long first, long second, long third, long fourth) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(window), first, second, third, fourth};
        std::memcpy(event.xclient.data.l, data, sizeof(data));
        XSendEvent(display, target, False, NoEventMask, &event);
        XFlush(display);
    }

    /// Hands over what was dropped.
    void answer(const XSelectionRequestEvent& request) const {
        XChangeProperty(display, request.requestor, request.property, request.target, 8,
                        PropModeReplace, reinterpret_cast<const unsigned char*>(uris.data()),
                        static_cast<int>(uris.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display, request.requestor, False, NoEventMask, &event);
        XFlush(display);
    }

    /// Waits for a message of the target, serving it meanwhile.
    bool await(const char* type) const {
        for (int waited = 0; waited < kPatienceMilliseconds;) {
            if (XPending(display) == 0) {
                usleep(10'000);
                waited += 10;
                continue;
            }
            XEvent event;
            XNextEvent(display, &event);
            if (event.type == SelectionRequest) answer(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(type))
                return true;
        }
        return false;
    }
};

/// The first window from `window` down that says it takes drops; 0 where there is none.
Window findTarget(Display* display, Window window, Atom aware) {
    Atom type = 0;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* value = nullptr;
    XGetWindowProperty(display, window, aware, 0, 1, False, AnyPropertyType, &type, &format, &count,
                       &left, &value);
    if (value != nullptr) XFree(value);
    if (count > 0) return window;
    Window root = 0, parent = 0, found = 0;
    Window* children = nullptr;
    unsigned childCount = 0;
    XQueryTree(display, window, &root, &parent, &children, &childCount);
    for (unsigned i = 0; i < childCount && found == 0; ++i)
        found = findTarget(display, children[i], aware);
    if (children != nullptr) XFree(children);
    return found;
}

int fail(const char* message) {
    std::fprintf(stderr, "drop_file: %s\n", message);
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return fail("expected one path");
    Source source;
    source.display = XOpenDisplay(nullptr);
    if (source.display == nullptr) return fail("no display");
    const Window root = DefaultRootWindow(source.display);
    source.uris = "file://" + std::string(argv[1]) + "\r\n";
    source.target = findTarget(source.display, root, source.atom("XdndAware"));
    if (source.target == 0) return fail("no window takes drops");
    source.window = XCreateSimpleWindow(source.display, root, 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(source.display, source.atom("XdndSelection"), source.window, CurrentTime);

    source.send("XdndEnter", kVersion << 24, static_cast<long>(source.atom("text/uri-list")), 0, 0);
    constexpr long kPlace = (100 << 16) | 100;
    source.send("XdndPosition", 0, kPlace, CurrentTime,
                static_cast<long>(source.atom("XdndActionCopy")));
    if (!source.await("XdndStatus")) return fail("the window says nothing of the file over it");
    source.send("XdndDrop", 0, CurrentTime, 0, 0);
    if (!source.await("XdndFinished")) return fail("the window does not take the file");
    XCloseDisplay(source.display);
    return 0;
}
