// SPDX-License-Identifier: MIT
#include "editor/drop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <chrono>
#include <optional>

namespace patina::editor_tests {
namespace {

using Clock = std::chrono::steady_clock;

constexpr long kVersion = 5;
constexpr int kPollMs = 20;

/// One drag, from a window of its own that nobody sees.
class DragSource {
  public:
    DragSource(const std::string& display, std::string uri_list, int seconds)
        : display_(XOpenDisplay(display.c_str())),
          uri_list_(std::move(uri_list)),
          until_(Clock::now() + std::chrono::seconds(seconds)) {
        if (display_ != nullptr)
            window_ =
                XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    }
    ~DragSource() {
        if (display_ != nullptr) XCloseDisplay(display_);
    }
    DragSource(const DragSource&) = delete;
    DragSource& operator=(const DragSource&) = delete;

    bool drop_at(int x, int y) {
        if (display_ == nullptr) return false;
        const std::optional<Window> target = window_at(x, y);
        if (!target) return false;
        target_ = *target;
        const auto type = static_cast<long>(atom("text/uri-list"));
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
        send("XdndEnter", kVersion << 24, type, 0, 0);
        send("XdndPosition", 0, (static_cast<long>(x) << 16) | y, CurrentTime,
             static_cast<long>(atom("XdndActionCopy")));
        const std::optional<XClientMessageEvent> status = wait_for("XdndStatus");
        if (!status || (status->data.l[1] & 1) == 0) return false;
        send("XdndDrop", 0, CurrentTime, 0, 0);
        return wait_for("XdndFinished").has_value();
    }

  private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    bool takes_files(Window window) const {
        Atom type = None;
        int format = 0;
        unsigned long count = 0;
        unsigned long rest = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_, window, atom("XdndAware"), 0, 1, False, XA_ATOM, &type,
                           &format, &count, &rest, &data);
        if (data != nullptr) XFree(data);
        return type == XA_ATOM && count > 0;
    }

    std::optional<Window> window_at(int x, int y) const {
        Window window = DefaultRootWindow(display_);
        while (window != None) {
            if (takes_files(window)) return window;
            Window child = None;
            int unused_x = 0;
            int unused_y = 0;
            XTranslateCoordinates(display_, DefaultRootWindow(display_), window, x, y, &unused_x,
                                  &unused_y, &child);
            window = child;
        }
        return std::nullopt;
    }

    void send(const char* message, long a, long b, long c, long d) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display_;
        event.xclient.window = target_;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        event.xclient.data.l[1] = a;
        event.xclient.data.l[2] = b;
        event.xclient.data.l[3] = c;
        event.xclient.data.l[4] = d;
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// The target asks for the names of the files.
    void answer(const XSelectionRequestEvent& request) const {
        const auto* bytes = reinterpret_cast<const unsigned char*>(uri_list_.data());
        XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                        PropModeReplace, bytes, static_cast<int>(uri_list_.size()));
        XEvent reply{};
        reply.xselection.type = SelectionNotify;
        reply.xselection.requestor = request.requestor;
        reply.xselection.selection = request.selection;
        reply.xselection.target = request.target;
        reply.xselection.property = request.property;
        reply.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &reply);
        XFlush(display_);
    }

    std::optional<XClientMessageEvent> wait_for(const char* message) const {
        while (Clock::now() < until_) {
            while (XPending(display_) > 0) {
                XEvent event{};
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest) answer(event.xselectionrequest);
                if (event.type == ClientMessage && event.xclient.message_type == atom(message))
                    return event.xclient;
            }
            pollfd connection{ConnectionNumber(display_), POLLIN, 0};
            ::poll(&connection, 1, kPollMs);
        }
        return std::nullopt;
    }

    ::Display* display_ = nullptr;
    Window window_ = None;
    Window target_ = None;
    std::string uri_list_;
    Clock::time_point until_;
};

}  // namespace

bool drop_file(const std::string& display, int x, int y, const std::filesystem::path& file,
               int seconds) {
    return DragSource(display, "file://" + file.string() + "\r\n", seconds).drop_at(x, y);
}

}  // namespace patina::editor_tests
